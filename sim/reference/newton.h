// The project's ground truth: implicit Euler steps and static equilibria of a Model in double precision by
// Newton's method with line search and a sparse factorisation.
//
//   step:   minimise 1/2 (u - u~)^T M (u - u~) + h^2 sum_e V_e Psi_e
//           with u~ = u_n + h v_n + h^2 g and v = (u - u_n) / h
//   static: minimise sum_e V_e Psi_e - f_ext.u, and half the stiffness of every spring times its squared length
//           with loads and prescribed motions applied in increments where one is too many for Newton's method
#pragma once
#include <Eigen/Core>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "sim/model/grab_spring.h"
#include "sim/model/model.h"
#include "sim/model/state.h"
#include "sim/model/state_fields.h"
#include "sim/scene/settings/solver_settings.h"

namespace fascia::reference {

/// Conserved quantities and quality of a state; the same names as in stats.json.
struct Measures {
  double kinetic = 0, elastic = 0;            // [J]
  double gravitational = 0;                   // [J], 0 at the rest positions
  double volume_ratio = 1;                    // of all tets together, over their volume at rest
  Eigen::Vector3d momentum{0, 0, 0};          // [kg m/s]
  Eigen::Vector3d angular_momentum{0, 0, 0};  // [kg m^2/s] about the origin
  /// Force of the supports on the body [N]: sum over held vertices, fixed or prescribed, of the elastic
  /// energy's gradient minus the weight. Inertia and viscous forces are not included.
  Eigen::Vector3d fixed_reaction{0, 0, 0};
  double min_det_f = 1, max_det_f = 1;  // range of J over tets
  double rms_strain = 0;                // root of the mean of |Green strain|^2 (Frobenius) over the volume
  int inverted = 0;                     // tets with J <= 0
};
Measures measure(const Model& model, const State& state);

/// What a body is held by: all of its fixed vertices, or those of one of its prescribed motions.
struct Support {
  std::size_t body;                   // in Model::bodies
  std::optional<std::size_t> motion;  // which of the body's, from 0; none: the fixed vertices
  Eigen::Vector3d force{0, 0, 0};     // on the body [N], as Measures::fixed_reaction, of which these are the parts
};
/// Body by body, the fixed vertices first; supports without vertices are left out.
std::vector<Support> support_forces(const Model& model, const State& state);

/// In file_mesh order; tets left out of the physics have zeros and J = 1.
StateFields export_fields(const Model& model, const State& state);

struct NewtonReport {
  int iterations = 0;
  /// |gradient| over free vertices / force scale: the largest norm over the mesh of the applied forces, of
  /// the internal forces (reactions included) and, in a step, of the forces that would stop its motion.
  double relative_residual = 0;
  bool converged = false;  // to the tolerance, or to the rounding of the gradient where that is larger
};

/// Keeps a reference to the model, which must not change.
class NewtonSolver {
 public:
  /// Meshes up to which a desktop has the time and the memory for its factor. A guess, and not enforced here.
  static constexpr std::size_t kMostTets = 200'000;

  /// A solve ends unconverged soon after `stop` is requested.
  NewtonSolver(const Model& model, const SolverSettings& settings, std::stop_token stop = {});
  ~NewtonSolver();
  /// One frame step: settings.substeps implicit Euler steps, each to a relative residual of 1e-12 or as far
  /// as double goes.
  NewtonReport step(State& state);
  /// Springs that pull from now on, several at a vertex if need be; none at first.
  void set_springs(const std::vector<GrabSpring>& springs);
  /// Static equilibrium from `state` (its velocity is set to zero, its time to the end of all motions).
  /// `tolerance` 0 means 1e-10. Throws Error if gravity pulls at a part of the mesh that nothing holds.
  NewtonReport solve_static(State& state, double tolerance = 0);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fascia::reference
