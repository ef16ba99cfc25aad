#include "sim/simulation/errors/true_error.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "sim/accuracy/mesh_error.h"
#include "sim/accuracy/relative_distance.h"

namespace fascia {

TrueError::~TrueError() { forget(); }

void TrueError::forget() {
  stop_.request_stop();
  if (running_.valid()) running_.wait();
  running_ = {};
  stop_ = {};
  waiting_.reset();
  result_.reset();
}

// `state`: the end of the exact step.
StepError TrueError::compare_solver(const Problem& problem, const SolvedStep& step, std::stop_token stop,
                                    State& state) {
  const IntegratorStage& stage = problem.stage;
  const std::size_t n = step.solution.size();
  state = State{step.previous, {}, problem.end_time - stage.duration};
  state.earlier.displacement = step.previous;
  const std::vector<char> held = problem.model.held();
  for (std::size_t v = 0; v < n; ++v) {
    // The velocity v* that leads to exactly the u~ of the solver, and the earlier displacement to its u*
    state.velocity.push_back((step.predicted[v] - step.from[v]) / stage.length);
    if (!held[v]) state.velocity.back() -= stage.length * problem.model.gravity;
    if (stage.extrapolation != 0)
      state.earlier.displacement[v] -= (step.from[v] - step.previous[v]) / stage.extrapolation;
  }
  state.earlier.velocity = state.velocity;
  state.contact = step.contact;
  reference::NewtonSolver solver(problem.model, problem.settings, stop);
  solver.set_springs(problem.springs);
  if (!problem.model.tools.empty()) solver.set_tools(problem.tools);
  StepError error;
  error.converged = solver.solve(stage, state).converged;
  error.step = problem.step;
  error.distance.reserve(n);
  double squared = 0, scale = 0, whole = 0;
  for (std::size_t v = 0; v < n; ++v) {
    const double distance = (step.solution[v] - state.displacement[v]).norm();
    squared += distance * distance;
    if (!held[v]) scale += (state.displacement[v] - step.predicted[v]).squaredNorm();
    whole += state.displacement[v].squaredNorm();
    error.largest = std::max(error.largest, distance);
    error.distance.push_back(static_cast<float>(distance));
  }
  error.relative = squared > 0 ? std::sqrt(squared / scale) : 0;
  error.of_displacement = squared > 0 ? std::sqrt(squared / whole) : 0;
  error.rms = std::sqrt(squared / static_cast<double>(n));
  error.displacement = std::sqrt(whole / static_cast<double>(n));
  return error;
}

StepError TrueError::compare(const Problem& problem, const SolvedStep& step, std::stop_token stop) {
  State exact;
  StepError error = compare_solver(problem, step, stop, exact);
  const State solved{step.solution, {}, 0};
  const MeshError mesh = estimate_mesh_error(problem.model, solved);
  error.mesh = mesh.displacement;
  error.peak_stress = {peak_distance(problem.model, solved, exact, stop), mesh.peak_stress};
  if (!problem.last) return error;
  if (const TimeError time = error_in_time(problem, stop); time.complete) error.time = time;
  return error;
}

TimeError TrueError::error_in_time(const Problem& problem, const std::stop_token& stop) {
  TimeExtrapolation extrapolation(order_of(problem.settings.integrator));
  LedTools led;  // which stay where they are
  led.restart(problem.last->led);
  const auto motion_of = [&](int parts, Integrator integrator) -> std::optional<Trajectory> {
    SolverSettings settings = problem.settings;
    settings.substeps *= parts;
    settings.integrator = integrator;
    reference::NewtonSolver solver(problem.model, settings, stop);
    solver.set_springs(problem.springs);
    State state = *problem.last;
    Trajectory motion;
    for (int k = 0; k < kFollowedSteps; ++k) {
      if (stop.stop_requested()) return std::nullopt;
      if (!led.empty()) solver.set_tools(led.motion(problem.model.tools, state.time, state.time + settings.time_step));
      solver.step(state);
      motion.displacement.push_back(state.displacement);
    }
    motion.peak_stress = peak_beyond_rounding(problem.model, state, stop);
    return motion;
  };
  const Integrator own = problem.settings.integrator;
  for (int parts = 1; extrapolation.wants_more(); parts *= 2) {
    std::optional<Trajectory> motion = motion_of(parts, own);
    if (!motion) return {.complete = false};
    extrapolation.add(std::move(*motion));
  }
  if (damps(own)) {
    std::optional<Trajectory> witness = motion_of(4, Integrator::sdirk2);
    if (!witness) return {.complete = false};
    extrapolation.add_witness(std::move(*witness));
  }
  return extrapolation.error();
}

void TrueError::begin(Simulation& simulation, bool with_time) {
  const GpuSolver& solver = *simulation.gpu();
  waiting_ = Problem{simulation.model,     simulation.scene.solver, solver.springs(),     solver.stage(),
                     solver.tool_motion(), solver.time(),           solver.steps_solved()};
  if (with_time) waiting_->last = simulation.state();
  snapshot_.request(solver.buffers());
}

bool TrueError::update(Simulation& simulation, bool continuously) {
  const bool news = !result_ || result_->step != simulation.gpu()->steps_solved();
  const bool due = (requested_ || (continuously && news)) && !waiting_ && !running_.valid();
  if (due && !simulation.uses_reference() && simulation.gpu()->has_step() && simulation.gpu()->last_was_whole() &&
      simulation.model.tets.size() <= kMostTets) {
    begin(simulation, requested_);
    requested_ = false;
  }
  if (waiting_)
    if (std::optional<SolvedStep> step = snapshot_.take(simulation.gpu()->buffers(), false)) {
      running_ = std::async(std::launch::async, [problem = std::move(*waiting_), step = std::move(*step),
                                                 stop = stop_.get_token()] { return compare(problem, step, stop); });
      waiting_.reset();
    }
  if (!running_.valid() || running_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
  result_ = running_.get();
  return true;
}

StepError TrueError::measure_solver(Simulation& simulation) {
  forget();
  if (simulation.uses_reference() || !simulation.gpu()->has_step()) return {};
  begin(simulation, false);
  State exact;
  const Problem problem = *std::exchange(waiting_, {});
  return compare_solver(problem, *snapshot_.take(simulation.gpu()->buffers(), true), stop_.get_token(), exact);
}

const StepError& TrueError::measure(Simulation& simulation) {
  if (simulation.model.tets.size() > kMostTets)
    throw Error(simulation.scene.file.string(), "has " + std::to_string(simulation.model.tets.size()) + " tets",
                "expected at most " + std::to_string(kMostTets) + " to compare with the exact step");
  forget();
  if (simulation.uses_reference() || !simulation.gpu()->has_step()) {
    result_.emplace();
    result_->distance.resize(simulation.model.rest_positions.size());
  } else {
    begin(simulation, false);
    result_ = compare(*waiting_, *snapshot_.take(simulation.gpu()->buffers(), true), stop_.get_token());
    waiting_.reset();
  }
  return *result_;
}

}  // namespace fascia
