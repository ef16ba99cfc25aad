// Reads the provenance of a file that fascia wrote.
#pragma once
#include <filesystem>
#include <optional>

#include "sim/output/run_provenance.h"

namespace fascia {

/// The provenance of a picture, a video, a replay, an exported state or stats.json. None if fascia did not write the
/// file. Throws Error for a file that cannot be read.
std::optional<Provenance> provenance_of_file(const std::filesystem::path& path);

}  // namespace fascia
