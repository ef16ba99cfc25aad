#include "app/paths.h"

#include <cstdlib>
#include <system_error>
#include <vector>

#include "sim/error.h"

namespace fascia {
namespace fs = std::filesystem;

fs::path find_data_dir(const std::string& data_dir) {
  const auto holds_shaders = [](const fs::path& folder) {
    std::error_code ec;
    return fs::is_directory(folder / "shaders", ec);
  };
  if (!data_dir.empty()) {
    if (!holds_shaders(data_dir)) throw Error("--data-dir " + data_dir, "has no folder shaders", "expected fascia's data folder");
    return data_dir;
  }
  std::vector<fs::path> candidates;
  if (const char* set = std::getenv("FASCIA_DATA_DIR")) candidates.emplace_back(set);
  std::error_code ec;
  const fs::path program = fs::read_symlink("/proc/self/exe", ec);
  if (!ec) {
    candidates.push_back(program.parent_path());
    candidates.push_back(program.parent_path().parent_path() / "share" / "fascia");
  }
  candidates.emplace_back(FASCIA_SOURCE_DIR);
  std::string tried;
  for (const fs::path& c : candidates) {
    if (holds_shaders(c)) return c;
    tried += (tried.empty() ? "" : ", ") + c.string();
  }
  throw Error("fascia", "its shaders were not found in " + tried, "name their parent folder with --data-dir");
}

fs::path default_scene(const fs::path& data_dir) { return data_dir / "assets" / "scenes" / "liver.json"; }

}  // namespace fascia
