// The project's ground truth: implicit Euler steps and static equilibria of a Model in double precision by
// Newton's method with line search and a sparse factorisation.
//
//   step:   minimise 1/2 (u - u~)^T M (u - u~) + h^2 sum_e V_e Psi_e,  u~ = u_n + h v_n + h^2 g,  v = (u -
//   u_n) / h static: minimise sum_e V_e Psi_e - f_ext.u with prescribed motions applied in increments (load
//   stepping)
#pragma once
#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "sim/model.h"
#include "sim/settings.h"
#include "sim/state_export.h"

namespace fascia::reference {

struct State {
  std::vector<Eigen::Vector3d> displacement;  // [vertex_count] u = x - X [m]
  std::vector<Eigen::Vector3d> velocity;      // [vertex_count] v [m/s]
  double time = 0;                            // [s]
};
State initial_state(const Model& model);

/// Conserved quantities and quality of a state; the same names as in stats.json.
struct Measures {
  double kinetic = 0, elastic = 0;                               // [J]
  Eigen::Vector3d momentum{0, 0, 0}, angular_momentum{0, 0, 0};  // [kg m/s], [kg m^2/s] about the origin
  Eigen::Vector3d fixed_reaction{0, 0,
                                 0};    // force of the supports on the body [N]: sum over held vertices of
                                        // (internal elastic force gradient - weight); inertia not included
  double min_det_f = 1, max_det_f = 1;  // range of J over tets
  int inverted = 0;                     // tets with J <= 0
};
Measures measure(const Model& model, const State& state);
StateFields export_fields(
    const Model& model,
    const State& state);  // in file_mesh order; tets left out of the physics: zeros, J = 1

struct NewtonReport {
  int iterations = 0;
  double relative_residual = 0;  // |gradient| over free vertices / largest applied or reaction force scale
  bool converged = false;
};

class NewtonSolver {
 public:
  NewtonSolver(const Model& model, const SolverSettings& settings);
  ~NewtonSolver();
  /// One frame step: settings.substeps implicit Euler steps, each to a relative residual of 1e-12 or as far
  /// as double goes.
  NewtonReport step(State& state);
  /// Static equilibrium from `state` (its velocity is set to zero, its time to the end of all motions).
  /// `tolerance` 0 means 1e-10.
  NewtonReport solve_static(State& state, double tolerance = 0);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fascia::reference
