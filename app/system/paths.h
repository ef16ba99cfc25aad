// Finds the program's shaders and shipped scenes.
#pragma once
#include <filesystem>
#include <string>

namespace fascia {

/// The folder that contains shaders/ and assets/: `data_dir` if given, which then also defines "assets:" in scenes,
/// else the first valid one of data_folders() (base/data_folder.h). Throws Error naming the folders that were tried.
std::filesystem::path find_data_dir(const std::string& data_dir);

std::filesystem::path default_scene(const std::filesystem::path& data_dir);

/// The shipped scene with the name `input`, for instance liver.json, where `input` has no folder and is no file here;
/// else `input` itself.
std::filesystem::path input_or_shipped(const std::string& input, const std::string& data_dir);
/// The line about `opened`, that input_or_shipped() returned for `input`; empty if both are the same.
std::string shipped_note(const std::string& input, const std::filesystem::path& opened);

}  // namespace fascia
