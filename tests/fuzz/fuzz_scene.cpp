// Scene files. A scene is read, written and read again, and must be the same. Carried files are extracted.
#include "sim/scene/scene.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(scene) {
  const Scene scene = read_scene_content("fuzz.json", data, {});
  fuzz::require(!scene.bodies.empty(), "a scene has bodies");
  const std::string text = scene_to_json(scene, "");
  const Scene copy = read_scene_content("fuzz.json", text, {});
  fuzz::require(scene_to_json(copy, "") == text, "a written scene reads back as it was");
  for (const KnownFile& file : scene.files)
    if (file.deflated)
      fuzz::require(carried_content(file, "fuzz.json").size() == file.size,
                    "a carried file has the size that is promised");
}
