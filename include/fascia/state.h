// A state of a simulation that a program keeps and restores later.
#pragma once
#include <memory>
#include <vector>

#include "fascia/export.h"

namespace fascia {
FASCIA_INLINE namespace api {
  /// A state of a simulation (Simulation::save(), Simulation::restore()). It holds displacements instead of positions
  /// because the solvers do; a restored state therefore has the same bits.
  struct State {
    struct Carried;  // Opaque to programs.

    std::vector<double> displacements{};  // [vertex_count][3] The displacements u = x - X [m].
    std::vector<double> velocities{};     // [vertex_count][3] The velocities v [m/s].
    double time = 0;                      // The simulated time [s].
    /// What the next step takes besides from the one before, as save() left it: forces of contact with their friction,
    /// and for bdf2 the substep before. Without it contact begins anew, and a body at rest on a slope slides a little.
    std::shared_ptr<const Carried> carried{};
  };

}  // namespace api
}  // namespace fascia
