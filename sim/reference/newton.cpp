#include "sim/reference/newton.h"

#include <algorithm>
#include <functional>

#include "sim/reference/minimizer.h"

namespace fascia::reference {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double step_tolerance = 1e-12;
constexpr double static_tolerance = 1e-10;
constexpr double increment_tolerance = 1e-6;  // of equilibria on the way, which only start the next increment
constexpr double smallest_increment = 1.0 / 1024;
constexpr int patience = 40;           // Newton iterations after which a smaller increment is tried
constexpr int last_patience = 400;     // where there is none to try

VectorXd flat(const std::vector<Vector3d>& vectors) {
  return Eigen::Map<const VectorXd>(vectors.empty() ? nullptr : vectors[0].data(), 3 * vectors.size());
}

std::vector<Vector3d> vectors_of(const VectorXd& all) {
  std::vector<Vector3d> result(all.size() / 3);
  for (std::size_t v = 0; v < result.size(); ++v) result[v] = all.segment<3>(3 * v);
  return result;
}

VectorXd per_component(const std::vector<double>& per_vertex) {
  VectorXd all(3 * per_vertex.size());
  for (std::size_t v = 0; v < per_vertex.size(); ++v) all.segment<3>(3 * v).setConstant(per_vertex[v]);
  return all;
}

// Moves the prescribed entries of `u` to where `motions` are at time t.
void place(const Model& model, const std::vector<Motion>& motions, double t, VectorXd& u) {
  for (const Motion& motion : motions)
    for (std::size_t k = 0; k < motion.vertices.size(); ++k) {
      const std::uint32_t v = motion.vertices[k];
      u.segment<3>(3 * v) = motion.position(k, model.rest_positions[v], t) - model.rest_positions[v];
    }
}

}  // namespace

struct NewtonSolver::Impl {
  Impl(const Model& m, const SolverSettings& s)
      : model(m), settings(s), system(model), minimizer(system), mass(per_component(lumped_masses(model))) {
    gravity = model.gravity.replicate(model.rest_positions.size(), 1);
  }

  NewtonReport substep(State& state);
  NewtonReport solve_static(State& state, double tolerance);

  /// Sets up the problem at a share s in (0, 1] of the way from the state at hand: the potential and, in the held entries
  /// of `target`, where held vertices go.
  using Path = std::function<void(double s, Potential& potential, VectorXd& target)>;
  /// Minimises at s = 1, from `u` by the largest increments of s that Newton's method survives with every tet upright.
  NewtonReport follow(const Path& path, bool divisible, double tolerance, VectorXd& u);

  const Model& model;
  const SolverSettings settings;
  const ElasticSystem system;
  Minimizer minimizer;
  const VectorXd mass;  // [3 * vertex_count] [kg]
  VectorXd gravity;     // [3 * vertex_count] [m/s^2]
};

NewtonReport NewtonSolver::Impl::follow(const Path& path, bool divisible, double tolerance, VectorXd& u) {
  NewtonReport total;
  const bool upright = system.min_det_f(u) > 0;
  Potential potential;
  double done = 0, increment = 1;
  while (done < 1) {
    const bool give_up = divisible && increment < smallest_increment;
    const double next = give_up ? 1 : std::min(1.0, done + increment);
    VectorXd trial = u, target = u;
    path(next, potential, target);
    if (const VectorXd change = target - u; !change.isZero(0)) minimizer.move_held(potential, change, trial);
    const bool last_resort = !divisible || give_up;
    const NewtonReport report = minimizer.minimize(potential, next < 1 ? increment_tolerance : tolerance,
                                                   last_resort ? last_patience : patience, trial);
    total.iterations += report.iterations;
    if (last_resort || (report.converged && (!upright || system.min_det_f(trial) > 0))) {
      u = std::move(trial);
      done = next;
      increment *= 2;
      total.relative_residual = report.relative_residual;
      total.converged = report.converged;
    } else {
      increment = (next - done) / 2;
    }
  }
  return total;
}

NewtonReport NewtonSolver::Impl::substep(State& state) {
  const double h = settings.substep();
  const VectorXd old = flat(state.displacement), velocity = flat(state.velocity);
  Potential fixed;
  fixed.inertia = mass / (h * h);
  fixed.target = old + h * velocity + h * h * gravity;
  fixed.start = old;
  fixed.force = VectorXd::Zero(old.size());
  if (system.viscous()) fixed.viscous = {system.strains(old), h};

  // Coasting is the better start, but not if it turns tets inside out.
  VectorXd u = old;
  system.add_to_free(system.free_part(velocity), h, u);
  if (system.min_det_f(u) <= 0 && system.min_det_f(old) > 0) u = old;

  VectorXd held = old;
  place(model, model.motions, state.time + h, held);
  const Path path = [&](double s, Potential& potential, VectorXd& target) {
    potential = fixed;
    for (std::size_t v = 0; v < system.first_dof().size(); ++v)
      if (system.first_dof()[v] < 0)
        target.segment<3>(3 * v) = old.segment<3>(3 * v) + s * (held - old).segment<3>(3 * v);
  };
  const NewtonReport report = follow(path, !model.motions.empty(), step_tolerance, u);
  state.displacement = vectors_of(u);
  state.velocity = vectors_of((u - old) / h);
  state.time += h;
  return report;
}

NewtonReport NewtonSolver::Impl::solve_static(State& state, double tolerance) {
  double end = state.time;
  for (const Motion& motion : model.motions) end = std::max(end, motion.start + motion.duration);
  // A jump would be a single increment: it is stretched over the whole path.
  std::vector<Motion> motions = model.motions;
  const double path_end = end > state.time ? end : state.time + 1;
  for (Motion& motion : motions)
    if (motion.duration == 0 && motion.start >= state.time) {
      motion.start = state.time;
      motion.duration = path_end - state.time;
    }

  const VectorXd weight = mass.cwiseProduct(gravity);
  VectorXd u = flat(state.displacement), out_of_balance;
  system.evaluate(u, {}, out_of_balance);
  out_of_balance = weight - out_of_balance;
  const VectorXd start = u;
  VectorXd path_start = u;
  place(model, motions, state.time, path_start);

  // At s = 0 the state is in equilibrium with a part of the load, and held where it is; both gaps close as s goes to 1.
  const Path path = [&](double s, Potential& potential, VectorXd& target) {
    potential.inertia = VectorXd::Zero(start.size());
    potential.target = potential.start = start;
    potential.force = weight - (1 - s) * out_of_balance;
    VectorXd held = start;
    place(model, motions, state.time + s * (path_end - state.time), held);
    for (std::size_t v = 0; v < system.first_dof().size(); ++v)
      if (system.first_dof()[v] < 0)
        target.segment<3>(3 * v) = (held + (1 - s) * (start - path_start)).segment<3>(3 * v);
  };
  const NewtonReport report = follow(path, true, tolerance > 0 ? tolerance : static_tolerance, u);
  state.displacement = vectors_of(u);
  state.velocity.assign(state.displacement.size(), Vector3d::Zero());
  state.time = end;
  return report;
}

NewtonSolver::NewtonSolver(const Model& model, const SolverSettings& settings)
    : impl_(std::make_unique<Impl>(model, settings)) {}
NewtonSolver::~NewtonSolver() = default;

NewtonReport NewtonSolver::step(State& state) {
  NewtonReport report;
  report.converged = true;
  for (int k = 0; k < impl_->settings.substeps; ++k) {
    const NewtonReport part = impl_->substep(state);
    report.iterations += part.iterations;
    report.relative_residual = std::max(report.relative_residual, part.relative_residual);
    report.converged = report.converged && part.converged;
  }
  return report;
}

NewtonReport NewtonSolver::solve_static(State& state, double tolerance) { return impl_->solve_static(state, tolerance); }

}  // namespace fascia::reference
