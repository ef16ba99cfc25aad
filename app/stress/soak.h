// Long runs: scenes are grabbed and released repeatedly, twice, to reveal drift and leaks.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/bench/bench.h"
#include "app/cli/discretization.h"

namespace fascia {

struct SoakRun {
  std::uint64_t hash = 0;                         // of the last state (state_hash)
  double elastic_first = 0, elastic_last = 0;     // at rest, after the first round of grabs and after the last one [J]
  double kinetic_last = 0;                        // at rest [J]
  double strained = 0;                            // largest elastic energy during grabs [J]
  std::size_t gpu_first = 0, gpu_last = 0;        // bytes, after the first round and at the end
  std::size_t memory_first = 0, memory_last = 0;  // resident set of the process, the same [bytes]
};

/// Runs `steps` steps of the scene, in rounds of four grabs in different directions with time to rest after each.
/// Throws Error if the state diverges.
SoakRun soak(Bench& bench, const Scene& scene, long steps);

/// The differences between two equal runs and other failures, one text each; empty: none.
std::vector<std::string> soak_failures(const SoakRun& first, const SoakRun& second);

/// Runs every scene twice, with this integrator and these elements if they are given, and writes soak.csv after each.
/// Returns the number of failures.
int soak_scenes(Bench& bench, const std::vector<std::filesystem::path>& inputs, long steps,
                const Discretization& discretization);

}  // namespace fascia
