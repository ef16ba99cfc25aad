// Compares times of benchmarks with those of an earlier run.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/bench/timing.h"

namespace fascia {

struct SpeedRow {
  std::string name;  // "5184 tets, two_level + subspace"
  Spread ms;         // per step
};

/// From a speed.csv of `fascia bench speed`. Throws Error for another file.
std::vector<SpeedRow> read_speeds(const std::filesystem::path& path);

struct SpeedChange {
  std::string name;
  double ratio;  // of the medians, now to then
  bool slower;   // beyond the noise: the median by a tenth, and a tenth of the times at least as long as the longest
                 // tenth of the earlier ones
};
/// Rows in both, in the order of `now`.
std::vector<SpeedChange> compare_speeds(const std::vector<SpeedRow>& then, const std::vector<SpeedRow>& now);

}  // namespace fascia
