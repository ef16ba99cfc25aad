// What is measured of a simulation.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fascia/export.h"

namespace fascia {
FASCIA_INLINE namespace api {
  /// Of the state as it is now, and of the last step.
  struct Diagnostics {
    double time = 0;                                     // simulated [s]
    double kinetic = 0, elastic = 0, gravitational = 0;  // [J]; gravitational: 0 at the rest positions
    double volume_ratio = 1;                             // of all tets together over their volume at rest
    double min_det_f = 1, max_det_f = 1;                 // range of J = det F over the tets; below 0 is inverted
    int inverted = 0;                                    // tets with J <= 0
    double max_strain = 0, max_von_mises = 0;            // Frobenius norm of the Green strain [-]; Cauchy stress [Pa]
    double max_speed = 0;                                // [m/s]
    Vec3 momentum{}, angular_momentum{};                 // [kg m/s]; [kg m^2/s] about the origin
    Vec3 reaction{};                                     // force of all supports on the tissue [N]
    Vec3 grab_force{};                                   // force of all grabs on the tissue [N]
    /// Of the last step, relative: 0 is solved, 1 is nothing solved. NaN before the first step.
    double residual = 0;
    std::optional<int> iterations{};  // of the last substep; where settings.tolerance ends them, or by Newton's method
  };

  /// What a body is held by: all of its fixed vertices, or those of one of its motions.
  struct Support {
    std::size_t body = 0;                 // index of the body
    std::optional<std::size_t> motion{};  // which motion of the body, from 0; none: the fixed vertices
    Vec3 force{};                         // on the tissue [N], of elasticity and weight
  };

  /// In the order of Simulation::tets().
  struct TetFields {
    std::vector<double> von_mises{};     // [tet_count] of the Cauchy stress [Pa]
    std::vector<double> det_f{};         // [tet_count] J [-]
    std::vector<double> green_strain{};  // [tet_count][6] xx, yy, zz, yz, xz, xy; tensor shears [-]
  };

  /// Of the search for a static equilibrium.
  struct StaticReport {
    int iterations = 0;            // of the scene's method
    int newton_iterations = 0;     // of Newton's method in double precision
    double relative_residual = 0;  // forces that are out of balance, over the largest of weight and inner forces
    bool converged = false;  // to 1e-5, or to settings.tolerance if that is given. Without any load it may stay false:
                             // all is rounding
  };

}  // namespace api
}  // namespace fascia
