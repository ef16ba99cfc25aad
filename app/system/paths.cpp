#include "app/system/paths.h"

#include "base/data_folder.h"
#include "base/error.h"

namespace fascia {
namespace fs = std::filesystem;

fs::path find_data_dir(const std::string& data_dir) {
  if (!data_dir.empty()) {
    if (!holds_shaders(data_dir))
      throw Error("--data-dir " + data_dir, "has no folder shaders", "expected fascia's data folder");
    set_data_folder(data_dir);
    return data_dir;
  }
  std::string tried;
  for (const fs::path& c : data_folders()) {
    if (holds_shaders(c)) return c;
    tried += (tried.empty() ? "" : ", ") + c.string();
  }
  throw Error("fascia", "its shaders were not found in " + tried, "name their parent folder with --data-dir");
}

fs::path default_scene(const fs::path& data_dir) { return data_dir / "assets" / "scenes" / "liver.json"; }

fs::path input_or_shipped(const std::string& input, const std::string& data_dir) {
  const fs::path path(input);
  std::error_code ignored;
  if (path.has_parent_path() || path.extension() != ".json" || fs::exists(fs::symlink_status(path, ignored)))
    return path;
  const fs::path shipped = default_scene(find_data_dir(data_dir)).parent_path() / path;
  return fs::exists(shipped, ignored) ? shipped : path;
}

std::string shipped_note(const std::string& input, const fs::path& opened) {
  return opened == input ? "" : input + ": no such file here; opened the shipped scene " + opened.string();
}

}  // namespace fascia
