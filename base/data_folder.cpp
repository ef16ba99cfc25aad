#include "base/data_folder.h"

#include <dlfcn.h>
#include <link.h>

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

/// The file that contains this code: libfascia.so in other programs, else the program.
fs::path own_file() {
  Dl_info info{};
  link_map* map = nullptr;
  std::error_code ec;
  const bool known =
      dladdr1(reinterpret_cast<const void*>(&own_file), &info, reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) != 0;
  // The program itself has no name there
  const bool in_library = known && map && map->l_name && map->l_name[0] != '\0';
  return in_library ? fs::canonical(map->l_name, ec) : fs::read_symlink("/proc/self/exe", ec);
}

}  // namespace

std::vector<fs::path> data_folders() {
  std::vector<fs::path> folders;
  if (const char* set = std::getenv("FASCIA_DATA_DIR")) folders.emplace_back(set);
  if (const fs::path file = own_file(); !file.empty()) {
    fs::path folder = file.parent_path();
    folders.push_back(folder);
    for (int up = 0; up < 2; ++up) {  // from bin, lib or lib/x86_64-linux-gnu
      folder = folder.parent_path();
      folders.push_back(folder / "share" / "fascia");
    }
  }
  folders.emplace_back(FASCIA_SOURCE_DIR);
  return folders;
}

bool holds_shaders(const fs::path& folder) {
  std::error_code ec;
  return fs::is_directory(folder / "shaders" / "sim", ec);  // many programs have a folder shaders
}

void set_data_folder(const fs::path& folder) { chosen() = folder; }

fs::path asset_folder() {
  if (!chosen().empty()) return chosen() / "assets";
  const std::vector<fs::path> folders = data_folders();
  const auto found = std::find_if(folders.begin(), folders.end(), holds_shaders);
  return found == folders.end() ? fs::path() : *found / "assets";
}

}  // namespace fascia
