#include "sim/fit/simulated/reference_simulator.h"

#include <algorithm>

#include "sim/contact/first_state.h"
#include "sim/integrators/integrator.h"
#include "sim/reference/newton.h"

namespace fascia {
namespace {

// Farther from equilibrium, a state is no result.
constexpr double kSolved = 1e-6;  // relative residual

bool is_solved(const reference::NewtonReport& report) { return report.converged || report.relative_residual < kSolved; }

// Of the stages that are kept for their rates.
constexpr double kMostBytes = 2e9;

bool is_worth_keeping(const Model& model, const SolverSettings& settings, long steps) {
  const double vectors = model.has_quadratic() ? 5 : 4;  // of a State at every vertex
  const double stages = static_cast<double>(steps) * settings.substeps * info_of(settings.integrator).stages;
  return !model.has_contact() &&
         stages * vectors * sizeof(Eigen::Vector3d) * static_cast<double>(model.rest_positions.size()) < kMostBytes;
}

// NewtonSolver::step() of a model without contact, which keeps its stages.
reference::NewtonReport step_by_stages(reference::NewtonSolver& solver, const SolverSettings& settings, State& state,
                                       std::vector<SimulatedStage>& stages) {
  reference::NewtonReport report;
  report.converged = true;
  const double end = state.time + settings.time_step;
  for (int k = 0; k < settings.substeps; ++k) {
    for (const IntegratorStage& stage : stages_of(settings.integrator, settings.substep(), state.earlier.step)) {
      stages.push_back({stage, end, state});
      report.join(solver.solve(stage, state));
    }
    state.earlier.step = settings.substep();
  }
  if (!info_of(settings.integrator).multistep) state.earlier = {};
  return report;
}

}  // namespace

std::optional<Course> ReferenceSimulator::run(const Scene& scene, const Model& model, const Schedule& schedule) const {
  return schedule.is_static ? equilibria(scene, model, schedule) : motion(scene, model, schedule);
}

std::optional<Course> ReferenceSimulator::equilibria(const Scene& scene, const Model& model,
                                                     const Schedule& schedule) const {
  Course course;
  course.moments = static_moments(model, schedule);
  course.differentiable = !model.has_contact();
  reference::NewtonSolver solver(model, scene.solver, stop_);
  State state = initial_state(model);
  for (Moment& moment : course.moments) {
    solver.set_springs(moment.springs);
    const auto until = moment.last ? std::nullopt : std::optional(moment.time);
    if (!is_solved(solver.solve_static(state, 0, until)) || !is_finite(state)) return std::nullopt;
    moment.state = state;
    moment.loads = solver.tool_loads();
    moment.contact = solver.contact_forces();
  }
  return course;
}

std::optional<Course> ReferenceSimulator::motion(const Scene& scene, const Model& model,
                                                 const Schedule& schedule) const {
  const double step = scene.solver.time_step;
  const ObservedSteps steps(schedule, step);
  reference::NewtonSolver solver(model, scene.solver, stop_);
  State state = first_state(model);
  Course course;
  const auto observe = [&](long number, double time, std::vector<GrabSpring> springs) {
    if (steps.numbers.contains(number))
      course.moments.push_back(
          {time, false, state, std::move(springs), solver.tool_loads(), solver.contact_forces(), course.stages.size()});
  };
  observe(0, 0, {});
  course.differentiable = is_worth_keeping(model, scene.solver, steps.count);
  for (long number = 1; number <= steps.count; ++number) {
    const double time = state.time + step;
    std::vector<GrabSpring> springs = with_grabs({}, model.grabs, time);
    solver.set_springs(springs);
    const reference::NewtonReport report =
        course.differentiable ? step_by_stages(solver, scene.solver, state, course.stages) : solver.step(state);
    if (stop_.stop_requested() || !is_solved(report) || !is_finite(state)) return std::nullopt;
    observe(number, time, std::move(springs));
  }
  return course;
}

}  // namespace fascia
