#include "app/system/user_files.h"

#include <cstdlib>

namespace fascia {
namespace {

namespace fs = std::filesystem;

// A relative path in these variables is invalid and ignored, as the specification requires.
fs::path folder_of(const char* variable, const char* below_home) {
  if (const char* set = std::getenv(variable); set && fs::path(set).is_absolute()) return fs::path(set) / "fascia";
  const char* home = std::getenv("HOME");
  return home && fs::path(home).is_absolute() ? fs::path(home) / below_home / "fascia" : fs::path();
}

}  // namespace

fs::path config_folder() { return folder_of("XDG_CONFIG_HOME", ".config"); }
fs::path state_folder() { return folder_of("XDG_STATE_HOME", ".local/state"); }

}  // namespace fascia
