// Names of files that are written without asking for a name.
#pragma once
#include <filesystem>
#include <string>

namespace fascia {

/// fascia-20250131-235959.png in the current folder; numbered if there is one from the same second.
std::filesystem::path dated_name(const std::string& ending);

}  // namespace fascia
