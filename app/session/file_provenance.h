// What made a file that fascia wrote.
#pragma once
#include <filesystem>
#include <optional>

#include "sim/output/run_provenance.h"

namespace fascia {

/// Of a picture, a video, a replay, an exported state or stats.json. Nothing if it is none of fascia's. Throws Error
/// for a file that cannot be read.
std::optional<Provenance> provenance_of_file(const std::filesystem::path& path);

}  // namespace fascia
