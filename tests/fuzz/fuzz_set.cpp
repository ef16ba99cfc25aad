// --set KEY=VALUE, one per line, on a scene of one body.
#include <algorithm>
#include <vector>

#include "sim/scene/scene.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(set) {
  std::vector<std::string> overrides;
  while (!data.empty()) {
    const std::size_t end = std::min(data.find('\n'), data.size());
    overrides.emplace_back(data.substr(0, end));
    data.remove_prefix(std::min(end + 1, data.size()));
  }
  const Scene scene = read_scene_content(
      "fuzz.json", R"({"fascia_scene": 1, "bodies": [{"mesh": "m.msh", "fixed": [{"lowest": 0.1}]}]})", overrides);
  scene_to_json(scene, "");
}
