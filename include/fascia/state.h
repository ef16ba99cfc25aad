// A state of a simulation that a program keeps and restores later.
#pragma once
#include <vector>

#include "fascia/export.h"

namespace fascia {
FASCIA_INLINE namespace api {
  /// A state of a simulation (Simulation::save(), Simulation::restore()). It holds displacements instead of positions
  /// because the solvers do; a restored state therefore has the same bits.
  struct State {
    std::vector<double> displacements{};  // [vertex_count][3] The displacements u = x - X [m].
    std::vector<double> velocities{};     // [vertex_count][3] The velocities v [m/s].
    double time = 0;                      // The simulated time [s].
  };

}  // namespace api
}  // namespace fascia
