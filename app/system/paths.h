// Where the program finds its shaders and shipped scenes.
#pragma once
#include <filesystem>
#include <string>

namespace fascia {

/// The folder that holds shaders/ and assets/: `data_dir` if given, which is then also where "assets:" in scenes leads,
/// else the first of data_folders() (base/data_folder.h) that does. Throws Error naming what was tried.
std::filesystem::path find_data_dir(const std::string& data_dir);

std::filesystem::path default_scene(const std::filesystem::path& data_dir);

}  // namespace fascia
