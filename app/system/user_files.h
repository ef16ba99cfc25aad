// Where a user's own files belong (XDG Base Directory Specification): settings, pictures that can be made again, the
// state of a session. In each, a folder "fascia". Empty where there is no home: then nothing is kept.
#pragma once
#include <filesystem>

namespace fascia {

std::filesystem::path config_folder();  // $XDG_CONFIG_HOME/fascia or ~/.config/fascia
std::filesystem::path state_folder();   // $XDG_STATE_HOME/fascia or ~/.local/state/fascia

}  // namespace fascia
