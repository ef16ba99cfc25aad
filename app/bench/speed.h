// fascia bench speed: what steps cost, for every pair of method and acceleration and meshes from 500 to a million tets;
// what it takes to open such a mesh and to draw it; and where the time of a step goes.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/bench/bench.h"
#include "app/bench/speed_table.h"

namespace fascia {

/// Writes speed.csv, meshes.csv and kernels.csv. Throws Error or Interrupted.
std::vector<SpeedRow> bench_speed(Bench& bench);

/// compared.csv, `now` over what the file holds. Returns the lines that name what became slower beyond the noise.
std::vector<std::string> compare_with(Bench& bench, const std::filesystem::path& against,
                                      const std::vector<SpeedRow>& now);

}  // namespace fascia
