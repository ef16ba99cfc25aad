// Where the program finds its shaders and shipped scenes.
#pragma once
#include <filesystem>
#include <string>

namespace fascia {

/// The folder that holds shaders/ and assets/: `data_dir` if given, else the environment's FASCIA_DATA_DIR, else the program's folder
/// or one above it, else the source tree it was built from. Throws Error naming what was tried.
std::filesystem::path find_data_dir(const std::string& data_dir);

std::filesystem::path default_scene(const std::filesystem::path& data_dir);

}  // namespace fascia
