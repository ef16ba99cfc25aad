#include "sim/reference/newton.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "base/error.h"
#include "sim/contact/contact_energy.h"
#include "sim/contact/pair_search.h"
#include "sim/contact/row_stiffness.h"
#include "sim/contact/step_loads.h"
#include "sim/model/prescribed_motion.h"
#include "sim/model/unconstrained_parts.h"
#include "sim/reference/held_path.h"
#include "sim/reference/minimizer.h"
#include "sim/tool/tool_approach.h"

namespace fascia::reference {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double step_tolerance = 1e-12;
constexpr double increment_tolerance = 1e-6;  // of intermediate equilibria, which only start the next increment
constexpr double smallest_increment = 1.0 / 128;
constexpr int patience = 40;        // Newton iterations after which a smaller increment is tried
constexpr int last_patience = 400;  // if no smaller one can be tried

// In statics, where nothing bounces: a stiffer penalty takes fewer passes over the multipliers.
constexpr double static_penalty = 100;
constexpr int most_passes = 60;
constexpr double first_fall = 1e-2;      // [s]
constexpr double steady_forces = 1e-9;   // change of the forces of contact in a pass, relative to the largest one
constexpr double rounded_forces = 1e-5;  // the same where rounding is what changes them
constexpr double borne_at_rest = 1e-5;   // force of inertia in bodies that have landed, relative to the largest one
constexpr double farthest_fall = 1e4;    // sizes of the tissue: beyond it nothing lands or stops

VectorXd per_component(const std::vector<double>& per_vertex) {
  VectorXd all(3 * per_vertex.size());
  for (std::size_t v = 0; v < per_vertex.size(); ++v) all.segment<3>(3 * v).setConstant(per_vertex[v]);
  return all;
}

// The sum of two parabolas is a parabola.
void add(const GrabSpring& spring, Potential& potential) {
  const Eigen::Index i = 3 * static_cast<Eigen::Index>(spring.vertex);
  const double inertia = potential.inertia[i], sum = inertia + spring.stiffness;
  if (sum == 0) return;
  potential.target.segment<3>(i) = (inertia * potential.target.segment<3>(i) + spring.stiffness * spring.target) / sum;
  potential.inertia.segment<3>(i).setConstant(sum);
}

}  // namespace

struct NewtonSolver::Impl {
  Impl(const Model& m, const SolverSettings& s, std::stop_token token)
      : model(m),
        settings(s),
        stop(std::move(token)),
        system(model),
        minimizer(system),
        mass(per_component(lumped_masses(model))),
        moving(model),
        gravity(model.gravity.replicate(model.rest_positions.size(), 1)),
        weight(per_component(consistent_masses(model)).cwiseProduct(gravity)),
        size(flattened(model.rest_positions).maxCoeff() - flattened(model.rest_positions).minCoeff()),
        contact(make_contact_surface(model)),
        penalty(contact_stiffness(model, contact)),
        pairs(model),
        loads{std::vector<ToolLoad>(model.tools.size()), {}} {
    for (const std::uint32_t part : unconstrained_parts(model, model.held()).part) falls.push_back(part != 0);
  }

  NewtonReport solve(const IntegratorStage& stage, const ToolMotion& motion, State& state);
  bool touches() const { return !contact.empty() || !pairs.empty(); }
  /// Of a step from `start` under the forces in `memory`; `end`: where velocities lead, if anything `moves`.
  std::shared_ptr<const ContactEnergy> contact_from(const VectorXd& start, const std::vector<Vector3d>& end,
                                                    const std::vector<double>& stiffness, const ToolMotion& motion,
                                                    ContactMemory& memory, const IntegratorStage* stage = nullptr,
                                                    double time = 0) {
    memory.resize(contact.row_count + pairs.row_count());
    const auto before = std::span<const ContactForce>(memory).subspan(contact.row_count);
    std::vector<Vector3d> path = end;
    if (stage && stage_length != stage->length)
      in_stage = stage_stiffness(model, contact, stiffness, stage_length = stage->length);
    rows = row_stiffness(model, contact, stage ? in_stage : stiffness, memory, motion, as_vectors(start), end);
    if (!stage)
      return std::make_shared<ContactEnergy>(model, contact, rows, memory, start, motion,
                                             pairs.find(as_vectors(start), end, before));
    if (!pairs.empty()) {
      const std::vector<char> carried = pairs.carried(before, time);
      for (std::size_t v = 0; v < path.size(); ++v)
        if (falls[v] && carried[v]) path[v] -= fall_in(*stage);
    }
    return std::make_shared<ContactEnergy>(model, contact, rows, memory, start, motion,
                                           pairs.find(as_vectors(start), path, before, stage->length, time), end);
  }
  /// After pairs.misses().
  std::shared_ptr<const ContactEnergy> contact_again(const VectorXd& start, const ToolMotion& motion,
                                                     const std::vector<Vector3d>& aim, ContactMemory& memory) {
    std::vector<PairRow> found = pairs.find_again();
    for (const PairRow& row : found) memory[contact.row_count + force_row(row.slot)].normal = row.before;
    return std::make_shared<ContactEnergy>(model, contact, rows, memory, start, motion, std::move(found), aim);
  }
  Vector3d fall_in(const IntegratorStage& stage) const { return stage.duration * stage.duration * model.gravity; }
  void read_out(std::shared_ptr<const ContactEnergy> energy, const VectorXd& u) {
    loads = {energy->loads(u), energy->pairs().loads(u)};
    touched = std::move(energy);
    touched_at = u;
  }
  ToolMotion motion_within(double from, double to) const {
    return tools ? *tools : motion_on_paths(model.tools, from, to);
  }
  NewtonReport solve_static(State& state, double tolerance, std::optional<double> until);
  /// The equilibrium at `end`, by one problem whose tools are where `motion` ends.
  NewtonReport equilibrium(State& state, double tolerance, double end, double moment, const ToolMotion& motion);
  /// eps* [tet_count].
  std::vector<Eigen::Matrix3d> strains(const IntegratorStage& stage, const VectorXd& now,
                                       const VectorXd& earlier) const;

  /// Minimizes potential(1) with the constrained vertices at the end of their path, from `u`, by the largest increments
  /// of s in (0, 1] for which Newton's method converges with every tet upright. `divisible`: whether smaller increments
  /// are smaller problems.
  NewtonReport follow(const HeldPath& path, const std::function<Potential(double s)>& potential, bool divisible,
                      double tolerance, VectorXd& u);

  /// Repeats the update of the multipliers in `memory` from the equilibrium `u` until the forces stay, or change by no
  /// more than rounding. A body that only contact supports `lands` first: it falls without speed, for longer in every
  /// pass, so that its inertia vanishes.
  void settle_forces(Potential potential, const std::vector<double>& stiffness, const ToolMotion& motion, bool lands,
                     double tolerance, NewtonReport& report, ContactMemory& memory, VectorXd& u);

  const Model& model;
  const SolverSettings settings;
  std::stop_token stop;
  std::vector<GrabSpring> springs;
  const ElasticSystem system;
  Minimizer minimizer;
  const VectorXd mass;  // lumped [3 * vertex_count] [kg]
  const MassMatrix moving;
  const VectorXd gravity, weight;  // [3 * vertex_count] [m/s^2], [N]
  const double size;               // of the tissue [m]
  const ContactSurface contact;
  const std::vector<double> penalty;  // [contact.points] [N/m]
  std::vector<double> rows;           // row_stiffness() of the last contact_from()
  PairSearch pairs;
  std::vector<char> falls;       // [vertex] in unconstrained parts
  std::vector<double> in_stage;  // [point] the penalty in stages of `stage_length` [s]
  double stage_length = 0;
  std::optional<ToolMotion> tools;  // none: on their paths
  ContactLoads loads;
  std::shared_ptr<const ContactEnergy> touched;  // of the last step or solve, which ended at `touched_at`
  VectorXd touched_at;                           // [3 * vertex_count] [m]
};

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

void NewtonSolver::Impl::settle_forces(Potential potential, const std::vector<double>& stiffness,
                                       const ToolMotion& motion, bool lands, double tolerance, NewtonReport& report,
                                       ContactMemory& memory, VectorXd& u) {
  const VectorXd start = potential.start;
  const double heaviest = lands ? weight.lpNorm<Eigen::Infinity>() : 0;  // of a vertex
  double change = 0, unsteady = 0, largest = 0;                          // [N]
  VectorXd from = u, inertia = VectorXd::Zero(u.size());
  const auto borne = [&] { return inertia.cwiseProduct(u - from).lpNorm<Eigen::Infinity>(); };  // [N] by falling
  for (int pass = 0; pass < most_passes && report.converged; ++pass) {
    unsteady = borne();
    if (lands) {
      potential.target = from = u;
      potential.inertia = inertia = mass / std::pow(first_fall * std::pow(2.0, pass), 2);
      for (const GrabSpring& spring : springs) add(spring, potential);
    }
    if (lands && pass == 0) {
      report = minimizer.minimize(potential, tolerance, {last_patience, false, stop}, u);
      unsteady = borne();
    }
    const ContactMemory before = std::exchange(memory, potential.contact->memory_after(u));
    read_out(potential.contact, u);
    const double previous = std::exchange(change, unsteady);
    largest = heaviest;
    for (std::size_t row = 0; row < memory.size(); ++row) {
      if (row >= contact.row_count && (row - contact.row_count) % 5 == 4) continue;  // what pairs met
      const ContactForce old = before.empty() ? ContactForce{} : before[row];
      change =
          std::max({change, std::abs(memory[row].normal - old.normal), (memory[row].friction - old.friction).norm()});
      largest = std::max(largest, memory[row].normal);
    }
    if (change <= steady_forces * largest) return;
    if (change <= rounded_forces * largest && change > 0.5 * previous && change <= potential.contact->rounding(u))
      return;
    if (lands && (u - start).lpNorm<Eigen::Infinity>() > farthest_fall * size) break;
    // Tissue that slides along tissue meets other faces.
    potential.contact = contact_from(pairs.empty() ? start : u, as_vectors(u), stiffness, motion, memory);
    report.go_on(minimizer.minimize(potential, tolerance, {last_patience, false, stop}, u));
  }
  if (!report.converged || unsteady <= std::max(borne_at_rest, tolerance) * largest) return;
  report.rests = report.converged = false;
}

NewtonReport NewtonSolver::Impl::solve_static(State& state, double tolerance, std::optional<double> until) {
  if (!touches()) require_supports(model);
  const double begin = state.time;
  const double end = std::max(begin, until ? *until : std::max(model.end_of_motions(), model.end_of_tools()));
  const double moment = until ? 1e-9 : 1e-3;  // [s] of a path to a time that has come
  const auto motion = [&](double from, double to) {
    if (!tools || begin == end) return motion_within(from, to);
    return tools->part((from - begin) / (end - begin), (to - begin) / (end - begin));
  };
  const auto depth = [&](std::size_t tool, const ToolPlace& place) {
    return depth_in_tissue(model, contact, state.displacement, tool, place);
  };
  NewtonReport report;
  for (const double time : approach_times(model.tools, contact.finest_parts, begin, end, size, motion, depth)) {
    const int before = report.iterations;
    report = equilibrium(state, tolerance, time, moment, motion(state.time, time));
    report.iterations += before;
    if (!report.converged || stop.stop_requested()) break;
  }
  return report;
}

NewtonReport NewtonSolver::Impl::equilibrium(State& state, double tolerance, double end, double moment,
                                             const ToolMotion& motion) {
  VectorXd u = flattened(state.displacement), internal;
  const HeldPath path(model, u, state.time, std::max(end, state.time + moment));

  // The state is in equilibrium with a part of the load; the rest is added as s increases to 1.
  system.evaluate(u, {}, internal);
  const VectorXd missing = weight - internal, start = u, zero = VectorXd::Zero(u.size());
  std::vector<double> stiffer = penalty;
  for (double& k : stiffer) k *= static_penalty;
  const auto potential = [&](double s) {
    Potential result{{}, zero, start, start, weight - (1 - s) * missing};
    if (touches()) result.contact = contact_from(start, as_vectors(start), stiffer, motion.part(0, s), state.contact);
    for (const GrabSpring& spring : springs) {  // their displacement is also applied gradually
      const Vector3d from = start.segment<3>(3 * static_cast<Eigen::Index>(spring.vertex));
      GrabSpring now = spring;
      now.target = from + s * (spring.target - from);
      add(now, result);
    }
    return result;
  };
  if (tolerance <= 0) tolerance = NewtonSolver::kStaticTolerance;
  const bool supported = !touches() || unconstrained_parts(model, model.held()).parts == 0;
  NewtonReport report;
  report.converged = true;
  if (supported) report = follow(path, potential, true, tolerance, u);
  if (touches()) settle_forces(potential(1), stiffer, motion, !supported, tolerance, report, state.contact, u);
  state.displacement = as_vectors(u);
  state.velocity.assign(state.displacement.size(), Vector3d::Zero());
  state.acceleration.clear();
  state.earlier = {};
  state.time = end;
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
