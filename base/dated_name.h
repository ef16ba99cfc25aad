// Names for files that are made without asking for one.
#pragma once
#include <filesystem>
#include <string>

namespace fascia {

/// fascia-20250131-235959.png in the current folder; numbered if there is one of the same second.
std::filesystem::path dated_name(const std::string& ending);

}  // namespace fascia
