#include "sim/reference/newton.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "base/error.h"
#include "sim/model/prescribed_motion.h"
#include "sim/reference/newton_impl.h"

namespace fascia::reference {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double step_tolerance = 1e-12;
constexpr double smallest_increment = 1.0 / 128;
constexpr int patience = 40;  // Newton iterations after which a smaller increment is tried

}  // namespace

NewtonReport NewtonSolver::Impl::follow(const HeldPath& path, const std::function<Potential(double)>& potential,
                                        bool divisible, double tolerance, VectorXd& u) {
  NewtonReport total;
  const double largest = path.largest_increment();
  // If small increments do not help or do not exist, any result is accepted.
  bool careful = divisible;
  const bool upright = system.min_det_f(u) > 0;
  double done = 0, increment = largest;
  while (done < 1 && !stop.stop_requested()) {
    const double next = std::min(1.0, done + increment);
    const Potential problem = potential(next);
    VectorXd trial = u, target = u;
    path.place(next, target);
    if (const VectorXd change = target - u; !change.isZero(0)) minimizer.move_held(problem, change, trial);
    const Minimizer::Limits limits{careful ? patience : last_patience, careful && upright, stop};
    const NewtonReport report = minimizer.minimize(problem, next < 1 ? increment_tolerance : tolerance, limits, trial);
    total.iterations += report.iterations;
    if (careful && !report.converged) {
      increment = (next - done) / 2;
      careful = increment >= smallest_increment * largest;
      if (!careful) increment = largest;
      continue;
    }
    u = std::move(trial);
    done = next;
    increment = std::min(2 * increment, largest);
    total.relative_residual = report.relative_residual;
    total.converged = report.converged;
  }
  return total;
}

std::vector<Eigen::Matrix3d> NewtonSolver::Impl::strains(const IntegratorStage& stage, const VectorXd& now,
                                                         const VectorXd& earlier) const {
  std::vector<Eigen::Matrix3d> strains = system.strains(now);
  if (stage.extrapolation == 0) return strains;
  const std::vector<Eigen::Matrix3d> before = system.strains(earlier);
  for (std::size_t i = 0; i < strains.size(); ++i) strains[i] = stage.extrapolated(strains[i], before[i]);
  return strains;
}

NewtonReport NewtonSolver::Impl::solve(const IntegratorStage& stage, const ToolMotion& motion, State& state) {
  if (stage.extrapolation != 0 && state.earlier.displacement.size() != state.displacement.size())
    throw Error("reference solver", "has no earlier state", "expected one for a stage that extrapolates");
  const VectorXd old = flattened(state.displacement), velocity = flattened(state.velocity);
  const VectorXd earlier = flattened(state.earlier.displacement);
  const VectorXd start = stage.extrapolated(old, earlier);
  Potential potential;
  potential.inertia = stage.inertia(moving.own());
  const VectorXd start_velocity = stage.extrapolated(velocity, flattened(state.earlier.velocity));
  potential.target = stage.predicted(start, start_velocity, gravity);
  potential.coupled = {&moving, 1 / (stage.length * stage.length), potential.target};
  potential.start = start;
  potential.force = VectorXd::Zero(old.size());
  for (const GrabSpring& spring : springs) add(spring, potential);
  if (system.viscous()) potential.viscous = {strains(stage, old, earlier), stage.length};
  std::vector<Vector3d> aim;
  if (touches()) {
    aim = as_vectors(old + stage.duration * velocity);
    for (std::size_t v = 0; v < aim.size(); ++v)
      if (falls[v]) aim[v] += fall_in(stage);
    place_prescribed(model, state.time + stage.duration, aim);
    potential.contact = contact_from(old, aim, penalty, motion, state.contact, &stage, state.time);
  }

  // The inertial prediction is the better start, but not if it inverts tets.
  VectorXd u = old;
  system.add_to_free(system.free_part(velocity), stage.duration, u);
  if (system.min_det_f(u) <= 0 && system.min_det_f(old) > 0) u = old;

  const HeldPath path(model, old, state.time, state.time + stage.duration);
  NewtonReport report = follow(
      path, [&](double) { return potential; }, path.moves(), step_tolerance, u);
  if (!path.moves() && minimizer.climbs(potential, old, u)) {
    u = old;
    report.go_on(minimizer.minimize(potential, step_tolerance, {last_patience, false, stop}, u));
  }
  int again = 0;
  for (; again < PairSearch::kMostSearches && pairs.misses(as_vectors(u)); ++again) {
    potential.contact = contact_again(old, motion, aim, state.contact);
    report.go_on(minimizer.minimize(potential, step_tolerance, {last_patience, false, stop}, u));
  }
  state.earlier.displacement = std::exchange(state.displacement, as_vectors(u));
  const VectorXd end_velocity = stage.velocity(u, start);
  state.earlier.velocity = std::exchange(state.velocity, as_vectors(end_velocity));
  const bool may_cut = again == PairSearch::kMostSearches || pairs.cuts();
  state.taken_back = may_cut && pairs.take_back(as_vectors(old), consistent_masses(model), stage.duration, state);
  report.taken_back = state.taken_back ? 1 : 0;
  if (!moving.is_diagonal()) state.acceleration = as_vectors(stage.acceleration(end_velocity, start_velocity));
  state.time += stage.duration;
  if (potential.contact) {
    read_out(potential.contact, u);
    state.contact = potential.contact->memory_after(u, stage.share);
  }
  return report;
}

NewtonSolver::NewtonSolver(const Model& model, const SolverSettings& settings, std::stop_token stop)
    : impl_(std::make_unique<Impl>(model, settings, std::move(stop))) {}
NewtonSolver::~NewtonSolver() = default;

NewtonReport NewtonSolver::step(State& state) {
  NewtonReport report;
  report.converged = true;
  const SolverSettings& settings = impl_->settings;
  const double start = state.time, whole = settings.time_step;
  const TimedMotion motion{impl_->motion_within(start, start + whole), start, start + whole};
  StepLoads loads;
  double share = 0;
  for (int k = 0; k < settings.substeps; ++k) {
    for (const IntegratorStage& stage : stages_of(settings.integrator, settings.substep(), state.earlier.step)) {
      if (share > 0) loads.add(share, impl_->loads);
      share = stage.share / settings.substeps;
      const double from = (state.time - start) / whole, to = from + stage.duration / whole;
      report.join(impl_->solve(stage, part_of(impl_->model.tools, motion, from, to), state));
    }
    state.earlier.step = settings.substep();
  }
  impl_->loads = loads.mean(std::move(impl_->loads));
  if (!info_of(settings.integrator).multistep) state.earlier = {};
  return report;
}

NewtonReport NewtonSolver::solve(const IntegratorStage& stage, State& state) {
  return impl_->solve(stage, impl_->motion_within(state.time, state.time + stage.duration), state);
}

void NewtonSolver::set_tools(const std::optional<ToolMotion>& motion) { impl_->tools = motion; }
void NewtonSolver::set_springs(const std::vector<GrabSpring>& springs) { impl_->springs = springs; }
void NewtonSolver::set_stop(std::stop_token stop) { impl_->stop = std::move(stop); }
const std::vector<ToolLoad>& NewtonSolver::tool_loads() const { return impl_->loads.tools; }
const std::vector<PairLoad>& NewtonSolver::pair_loads() const { return impl_->loads.pairs; }

std::vector<Vector3d> NewtonSolver::contact_forces() const {
  VectorXd gradient = VectorXd::Zero(3 * static_cast<Eigen::Index>(impl_->model.rest_positions.size()));
  if (impl_->touched) impl_->touched->evaluate(impl_->touched_at, gradient);
  return as_vectors(-gradient);
}

NewtonReport NewtonSolver::solve_static(State& state, double tolerance, std::optional<double> until) {
  return impl_->solve_static(state, tolerance, until);
}

}  // namespace fascia::reference
