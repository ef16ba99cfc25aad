// A moment of a simulation that can be kept and gone back to.
#pragma once
#include <vector>

#include "fascia/export.h"

namespace fascia {
FASCIA_INLINE namespace api {
  /// Displacements rather than positions, since these are what the solvers hold: restoring gives back the same bits.
  struct State {
    std::vector<double> displacements{};  // [vertex_count][3] u = x - X [m]
    std::vector<double> velocities{};     // [vertex_count][3] v [m/s]
    double time = 0;                      // [s]
  };

}  // namespace api
}  // namespace fascia
