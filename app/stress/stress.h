// fascia stress: the stress suite, cases for every choice of method and acceleration, each a replay with criteria that
// can fail.
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/replay/replay.h"

namespace fascia {

/// What must hold besides finite values and no diverged vertex (sim/gpu/readback/state_guard.h). Sizes: diagonals
/// of the box around the body at rest.
struct StressCriteria {
  double farthest = 3;               // no displacement is longer than so many sizes, at any step
  bool keeps_upright = true;         // no tet is inside out at the end
  bool recovers = false;             // the RMS displacement ends below 1e-3 sizes
  bool creates_no_energy = false;    // kinetic + elastic + potential never exceeds the start's by more than 2 %
  bool creates_no_momentum = false;  // linear and angular, of a free body without gravity, by more than 2 %
};

struct StressCase {
  std::string group, name;  // "start", "mirrored E=1e9"
  Replay replay;            // its scene says which pair; its mesh lies in the output folder
  StressCriteria criteria;
};

/// All cases for one pair. Writes their meshes into `folder`. `quick`: meshes of a sixth of the tets.
std::vector<StressCase> stress_cases(const SolverChoice& pair, MaterialModel model, const std::filesystem::path& folder,
                                     bool quick);

struct StressResult {
  std::vector<std::string> failures;  // "not finite after 12 steps"; empty: passed
  long steps = 0;                     // made: fewer than asked for where the state was lost
  double recovered_after = -1;   // [s] from when on the RMS displacement stays below 1e-3 sizes; negative: it does not
  double rms = 0, farthest = 0;  // displacement at the end, RMS, and largest of all steps, in sizes
  double energy_growth = 0;      // largest, over the scale of the start's energy
  double momentum_growth = 0;    // the same of momenta
  int inverted = 0;              // tets at the end
};

class Simulation;
StressResult run_stress_case(Simulation& simulation, const StressCriteria& criteria);

}  // namespace fascia
