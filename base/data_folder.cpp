#include "base/data_folder.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace fascia {
namespace fs = std::filesystem;
namespace {

fs::path& chosen() {
  static fs::path folder;
  return folder;
}

}  // namespace

std::vector<fs::path> data_folders() {
  std::vector<fs::path> folders;
  if (const char* set = std::getenv("FASCIA_DATA_DIR")) folders.emplace_back(set);
  std::error_code ec;
  const fs::path program = fs::read_symlink("/proc/self/exe", ec);
  if (!ec) {
    folders.push_back(program.parent_path());
    folders.push_back(program.parent_path().parent_path() / "share" / "fascia");
  }
  folders.emplace_back(FASCIA_SOURCE_DIR);
  return folders;
}

bool holds_shaders(const fs::path& folder) {
  std::error_code ec;
  return fs::is_directory(folder / "shaders", ec);
}

void set_data_folder(const fs::path& folder) { chosen() = folder; }

fs::path asset_folder() {
  if (!chosen().empty()) return chosen() / "assets";
  const std::vector<fs::path> folders = data_folders();
  const auto found = std::find_if(folders.begin(), folders.end(), holds_shaders);
  return found == folders.end() ? fs::path() : *found / "assets";
}

}  // namespace fascia
