// Measurements of a simulation: energies, momenta, forces, stresses and the quality of the state.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fascia/export.h"

namespace fascia {
FASCIA_INLINE namespace api {
  /// Measurements of the current state and of the last step (Simulation::diagnostics()).
  struct Diagnostics {
    double time = 0;           // The simulated time [s].
    double kinetic = 0;        // The kinetic energy [J].
    double elastic = 0;        // The elastic energy [J].
    double gravitational = 0;  // The energy of the weight [J]. It is 0 at the rest positions.
    double volume_ratio = 1;   // The volume of all tets together over their volume at rest [-].
    double min_det_f = 1;      // The smallest J = det F of all tets [-]. It is negative if a tet is inverted.
    double max_det_f = 1;      // The largest J = det F of all tets [-].
    int inverted = 0;          // The number of tets with J <= 0.
    double max_strain = 0;     // The largest Frobenius norm of the Green strain [-].
    double max_von_mises = 0;  // The largest von Mises stress of the Cauchy stress [Pa].
    double max_speed = 0;      // The largest speed of a vertex [m/s].
    Vec3 momentum{};           // The linear momentum [kg m/s].
    Vec3 angular_momentum{};   // The angular momentum about the origin [kg m^2/s].
    Vec3 reaction{};           // The force of all supports on the tissue [N].
    Vec3 grab_force{};         // The force of all grabs on the tissue [N].
    /// The relative residual of the last step [-]: 0 is an exact solution, 1 is the residual of the start. It is NaN
    /// before the first step.
    double residual = 0;
    /// The iterations of the last substep. The value is empty unless Settings::tolerance ends iterations, or Newton's
    /// method makes them.
    std::optional<int> iterations{};
  };

  /// The force of a support on a body (Simulation::supports()). A support is either all fixed vertices of the body or
  /// the vertices of one of its motions.
  struct Support {
    std::size_t body = 0;                 // The index of the body.
    std::optional<std::size_t> motion{};  // The index of the motion in the body. It is empty for the fixed vertices.
    Vec3 force{};                         // The force on the tissue [N], which balances elasticity and weight.
  };

  /// Fields over the tets, in the order of Simulation::tets().
  struct TetFields {
    std::vector<double> von_mises{};     // [tet_count] The von Mises stress of the Cauchy stress [Pa].
    std::vector<double> det_f{};         // [tet_count] J = det F [-].
    std::vector<double> green_strain{};  // [tet_count][6] The Green strain [-]: xx, yy, zz, yz, xz, xy; tensor shears.
  };

  /// The Cauchy stress recovered at the vertices (Simulation::recovered_stress()). It is nearer to that of a finer mesh
  /// than the stresses of the tets around. A vertex where materials meet has the stress of the one with the larger von
  /// Mises stress.
  struct RecoveredStress {
    std::vector<double> cauchy{};     // [vertex_count][6] The stress [Pa]: xx, yy, zz, yz, xz, xy; 0 without tets.
    std::vector<double> von_mises{};  // [vertex_count] The von Mises stress [Pa].
    double max_von_mises = 0;         // The largest von Mises stress [Pa]. It is NaN if a stress is not finite.
    double p99_von_mises = 0;         // The von Mises stress that 1 % of the volume exceeds [Pa], or NaN.
  };

  /// The result of the search for a static equilibrium (Simulation::solve_static()).
  struct StaticReport {
    int iterations = 0;            // The iterations of the scene's method.
    int newton_iterations = 0;     // The iterations of Newton's method in double precision.
    double relative_residual = 0;  // The forces out of balance over the largest of weight and inner forces [-].
    /// True if the relative residual is at most 1e-5, or at most Settings::tolerance if that is not 0. Without any load
    /// it can stay false, because all forces are rounding errors.
    bool converged = false;
  };

}  // namespace api
}  // namespace fascia
