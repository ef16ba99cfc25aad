// fascia bench speed: the cost of steps for every solver choice and for meshes from 500 to a million tets, of opening
// and drawing such a mesh, and of each kernel of a step.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/bench/bench.h"
#include "app/bench/speed_table.h"

namespace fascia {

/// Writes speed.csv, meshes.csv and kernels.csv. Throws Error or Interrupted.
std::vector<SpeedRow> bench_speed(Bench& bench);

/// Writes compared.csv, `now` relative to the content of the file. Returns a line for each row that became slower
/// beyond the noise.
std::vector<std::string> compare_with(Bench& bench, const std::filesystem::path& against,
                                      const std::vector<SpeedRow>& now);

}  // namespace fascia
