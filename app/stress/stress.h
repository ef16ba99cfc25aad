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

/// Requirements in addition to finite values and no diverged vertex (sim/gpu/readback/state_guard.h). The unit of sizes
/// is the diagonal of the box around the body at rest.
struct StressCriteria {
  double farthest = 3;               // no displacement exceeds this number of sizes at any step
  bool keeps_upright = true;         // no tet is inverted at the end
  bool recovers = false;             // the RMS displacement ends below 1e-3 sizes
  bool creates_no_energy = false;    // kinetic + elastic + potential never exceeds the initial value by more than 2 %
  bool creates_no_momentum = false;  // linear and angular, of a free body without gravity, by more than 2 %
  /// Energies at rest: "no tet inverted" can hide one that is stretched eight times.
  bool springs_back = false;        // kinetic + elastic end below 1e-4 of the largest elastic energy of the run
  bool lies_still = false;          // no vertex moves by 1e-6 sizes in the second half
  bool stays_apart = false;         // no triangles of the surface cut each other at the end
  bool carries_its_weight = false;  // elastic ends below the work of gravity, kinetic below 1e-3 of it
};

struct StressCase {
  std::string group, name;  // "start", "mirrored E=1e9"
  Replay replay;            // its scene has the solver choice; its mesh is in the output folder
  StressCriteria criteria;
};

/// Whether the method carries bodies of this law and these elements.
bool can_run(Method method, MaterialModel model, ElementOrder elements);

/// All cases for one solver choice. Writes their meshes into `folder`. `quick`: meshes with a sixth of the tets.
std::vector<StressCase> stress_cases(const SolverChoice& pair, MaterialModel model, Integrator integrator,
                                     ElementOrder elements, const std::filesystem::path& folder, bool quick);

struct StressResult {
  std::vector<std::string> failures;  // "not finite after 12 steps"; empty: passed
  long steps = 0;                     // completed: fewer than requested if the state diverged
  double recovered_after = -1;        // [s] after which the RMS displacement stays below 1e-3 sizes; negative: never
  double rms = 0, farthest = 0;       // displacement at the end, RMS, and largest of all steps, in sizes
  double energy_growth = 0;           // largest, relative to the scale of the initial energy
  double momentum_growth = 0;         // the same of momenta
  int inverted = 0;                   // tets at the end
  double least_volume_ratio = 1;      // J at the end
  double elastic = 0;                 // energy at the end [J]
};

class Simulation;
StressResult run_stress_case(Simulation& simulation, const StressCriteria& criteria);

}  // namespace fascia
