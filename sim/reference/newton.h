// The reference solver, the ground truth of all tests: time steps and static equilibria of a Model in double precision
// by Newton's method with line search and a sparse factorization.
//
//   step:   minimize 1/2 (u - u~)^T M (u - u~) + l^2 sum_e V_e Psi_e
//           with l and u~ of the settings' integrator (sim/integrators/stage.h)
//   static: minimize sum_e V_e Psi_e - f_ext.u, and half the stiffness of every spring times its squared length
//           with loads and prescribed motions applied in increments where Newton's method cannot apply them at once
//
// Both with the energy of contact (sim/contact/contact_energy.h) where the model has any. A step updates its
// multipliers once at the end, statics until the forces no longer change.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "sim/contact/pair_energy.h"
#include "sim/contact/tool_load.h"
#include "sim/integrators/stage.h"
#include "sim/model/grab_spring.h"
#include "sim/model/model.h"
#include "sim/model/state.h"
#include "sim/model/state_fields.h"
#include "sim/scene/settings/solver_settings.h"
#include "sim/tool/tool_motion.h"

namespace fascia::reference {

/// Conserved quantities and quality measures of a state, with the same names as in stats.json.
struct Measures {
  double kinetic = 0, elastic = 0;            // [J]
  double gravitational = 0;                   // [J], 0 at the rest positions
  double volume_ratio = 1;                    // of all tets together, over their volume at rest
  Eigen::Vector3d momentum{0, 0, 0};          // [kg m/s]
  Eigen::Vector3d angular_momentum{0, 0, 0};  // [kg m^2/s] about the origin
  /// Force of the supports on the body [N]: sum over constrained vertices, fixed or prescribed, of the elastic energy's
  /// gradient minus the weight, and what they pass on to centroids of quadratic tets that free vertices move, too, by
  /// State::acceleration, and without what contact presses on these vertices. Their own inertia and viscous forces are
  /// not included.
  Eigen::Vector3d fixed_reaction{0, 0, 0};
  double min_det_f = 1, max_det_f = 1;       // range of J over tets: of quadratic ones at their points and corners
  double max_strain = 0, max_von_mises = 0;  // Green strain (Frobenius) and Cauchy stress [Pa], largest at a point
  double rms_strain = 0;                     // root of the mean of |Green strain|^2 (Frobenius) over the volume
  int inverted = 0;                          // tets with J <= 0 somewhere there
};
/// `contact`: [vertex] forces of contact on the tissue [N], or empty.
Measures measure(const Model& model, const State& state, const std::vector<Eigen::Vector3d>& contact = {});

/// What constrains a body: all of its fixed vertices, or those of one of its prescribed motions.
struct Support {
  std::size_t body;                   // in Model::bodies
  std::optional<std::size_t> motion;  // index among the body's motions, from 0; none: the fixed vertices
  Eigen::Vector3d force{0, 0, 0};     // on the body [N]; all supports add up to Measures::fixed_reaction
};
/// Body by body, the fixed vertices first; supports without vertices are left out. `contact` as of measure().
std::vector<Support> support_forces(const Model& model, const State& state,
                                    const std::vector<Eigen::Vector3d>& contact = {});

/// In file_mesh order; tets excluded from the simulation have zeros and J = 1. Values of quadratic tets are those at
/// the centroid, their stress has the averaged change of volume.
StateFields export_fields(const Model& model, const State& state);

struct NewtonReport {
  int iterations = 0;
  /// |gradient| over free vertices / force scale: the largest norm over the mesh of the applied forces, of the internal
  /// forces (reactions included) and, in a step, of the forces that would stop its motion.
  double relative_residual = 0;
  bool converged = false;  // to the tolerance, or to the rounding of the gradient where that is larger
  /// Of a static solve: false if bodies without supports went on falling or sliding. It then has not converged,
  /// although each of its minimizations did.
  bool rests = true;
  /// Of a static solve: its result would have tissue beyond a tool, or other tissue, that it has gone through. It then
  /// has not converged.
  bool goes_through = false;
  int taken_back = 0;  // stages whose result would have led tissue through tissue (PairSearch::taken_back())

  /// The same solve went on, as `more` reports.
  void go_on(const NewtonReport& more) {
    iterations += more.iterations;
    relative_residual = more.relative_residual;
    converged = more.converged;
    taken_back += more.taken_back;
  }
  /// Another solve, as `next` reports, came after it: both together.
  void join(const NewtonReport& next) {
    iterations += next.iterations;
    relative_residual = std::max(relative_residual, next.relative_residual);
    converged = converged && next.converged;
    taken_back += next.taken_back;
  }
};

/// Keeps a reference to the model, which must not change.
class NewtonSolver {
 public:
  /// Largest mesh for which a desktop has the time and the memory for a factor. An estimate, not enforced here.
  static constexpr std::size_t kMostTets = 200'000;
  static constexpr double kStaticTolerance = 1e-10;  // of the relative residual of statics, by default

  /// A solve ends unconverged soon after `stop` is requested.
  NewtonSolver(const Model& model, const SolverSettings& settings, std::stop_token stop = {});
  ~NewtonSolver();
  /// One frame step: settings.substeps substeps, each of whose stages is solved to a relative residual of 1e-12 or to
  /// the limit of double precision.
  NewtonReport step(State& state);
  /// One stage alone, of any integrator. Throws Error if it extrapolates from a state without State::earlier.
  NewtonReport solve(const IntegratorStage& stage, State& state);
  /// Sets the springs; several at a vertex are possible, and initially there are none.
  void set_springs(const std::vector<GrabSpring>& springs);
  /// Sets the motion of the tools in the steps and solves that follow, each of which begins and ends with it. None, as
  /// initially: they follow their paths.
  void set_tools(const std::optional<ToolMotion>& motion);
  /// Replaces the token of the constructor.
  void set_stop(std::stop_token stop);
  /// [tool] over the last step (sim/contact/step_loads.h), or at the end of a stage or solve that was the last call.
  const std::vector<ToolLoad>& tool_loads() const;
  const std::vector<PairLoad>& pair_loads() const;  // of tissue on tissue, in the same step
  /// [vertex] of contact on the tissue [N], at the end of the last stage; zero before the first one or without tools.
  std::vector<Eigen::Vector3d> contact_forces() const;
  /// Static equilibrium from `state` (its velocity is set to zero, its time to `until`, where motions and tools then
  /// are; without it to the end of all motions). `tolerance` 0 means kStaticTolerance. Throws Error if gravity acts on
  /// an unconstrained component and there is no tool to support it.
  NewtonReport solve_static(State& state, double tolerance = 0, std::optional<double> until = std::nullopt);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fascia::reference
