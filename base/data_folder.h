// Finds the folder with the program's shaders and shipped scenes. A scene's path that begins with "assets:" is relative
// to its subfolder assets.
#pragma once
#include <filesystem>
#include <vector>

namespace fascia {

/// Candidates in order of precedence: FASCIA_DATA_DIR, the folder of the program or of libfascia.so, share/fascia
/// beside or above that, the source tree.
std::vector<std::filesystem::path> data_folders();
bool holds_shaders(const std::filesystem::path& folder);

/// Sets the folder, regardless of data_folders().
void set_data_folder(const std::filesystem::path& folder);

/// The folder of shipped meshes and scenes; empty if there is none.
std::filesystem::path asset_folder();

}  // namespace fascia
