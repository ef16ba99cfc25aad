// Folders for a user's files (XDG Base Directory Specification): settings, and the state of a session. In each, a
// folder "fascia". Empty if there is no home: then no files are kept.
#pragma once
#include <filesystem>

namespace fascia {

std::filesystem::path config_folder();  // $XDG_CONFIG_HOME/fascia or ~/.config/fascia
std::filesystem::path state_folder();   // $XDG_STATE_HOME/fascia or ~/.local/state/fascia

}  // namespace fascia
