// The folder with the program's shaders and shipped scenes. A scene's path that begins with "assets:" is one in its
// folder assets.
#pragma once
#include <filesystem>
#include <vector>

namespace fascia {

/// Where it may be, in the order in which they count: FASCIA_DATA_DIR, the folder of the program or of libfascia.so,
/// share/fascia beside or above that, the source tree.
std::vector<std::filesystem::path> data_folders();
bool holds_shaders(const std::filesystem::path& folder);

/// This one, whatever data_folders() says.
void set_data_folder(const std::filesystem::path& folder);

/// Of shipped meshes and scenes; empty where there is none.
std::filesystem::path asset_folder();

}  // namespace fascia
