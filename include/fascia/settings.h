// Settings of the solver: method, acceleration, iterations and time step.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "fascia/export.h"

namespace fascia {
FASCIA_INLINE namespace api {
  /// Settings of the solver. A call that receives a value out of range, or a pair of method and acceleration that
  /// solver_pairs() does not list, throws Error.
  struct Settings {
    /// The method, as in scene files.
    std::string method = "two_level";
    /// The acceleration of the method, as in scene files.
    std::string acceleration = "subspace";
    /// The time integrator, as in scene files: "implicit_euler", "bdf2" or "sdirk2".
    std::string integrator = "implicit_euler";
    /// The largest number of iterations per substep, 1 to 10000.
    int iterations = 10;
    /// The relative residual at which the iterations of a substep stop [-], 0 to 1. With 0 all iterations run.
    double tolerance = 0;
    /// The length of one step [s], 1e-6 to 1.
    double time_step = 1.0 / 60.0;
    /// The number of equal parts of a step, 1 to 1000.
    int substeps = 1;
    /// The wall time of a step [ms], 0 to 10000. A step makes as many iterations as fit into it, up to `iterations`.
    /// With 0 there is no limit.
    double frame_budget = 0;
    /// The number of colors of the method "gauss_seidel", 0 to 64. With 0 the mesh decides.
    int colors = 0;
    /// The spectral radius of the acceleration "chebyshev" [-], 0 to 0.9999. With 0 it is estimated.
    double spectral_radius = 0;
    /// The number of earlier iterations that the acceleration "anderson" combines, 1 to 10.
    int window = 5;
    /// The speed, in sizes of the scene per second [1/s], below which tissue falls asleep, 0 to 1. With 0 nothing falls
    /// asleep.
    double rest_speed = 1e-5;
    bool operator==(const Settings&) const = default;
  };

  /// Returns method and acceleration of all pairs that can be set, the best pair first.
  FASCIA_EXPORT std::vector<std::pair<std::string, std::string>> solver_pairs();

}  // namespace api
}  // namespace fascia
