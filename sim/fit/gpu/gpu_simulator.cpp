#include "sim/fit/gpu/gpu_simulator.h"

#include "sim/simulation/simulation.h"
#include "sim/simulation/static_equilibrium.h"

namespace fascia {
namespace {

std::vector<ToolLoad> tool_loads(Simulation& simulation) {
  if (simulation.model.tools.empty()) return {};
  simulation.gpu()->request_diagnostics();
  return simulation.gpu()->take_diagnostics(true)->tool_loads;
}

std::optional<Course> equilibria(Simulation& simulation, const Schedule& schedule, const std::stop_token& stop) {
  Course course;
  course.moments = static_moments(simulation.model, schedule);
  for (Moment& moment : course.moments) {
    const auto until = moment.last ? std::nullopt : std::optional(moment.time);
    const StaticReport report = simulation.solve_static({}, stop, until);
    if (stop.stop_requested()) return std::nullopt;
    require_equilibrium(simulation, report);
    moment.state = simulation.state();
    moment.loads = tool_loads(simulation);
    moment.contact = simulation.contact_forces();
  }
  return course;
}

std::optional<Course> motion(Simulation& simulation, const Schedule& schedule, const std::stop_token& stop) {
  const ObservedSteps steps(schedule, simulation.scene.solver.time_step);
  Course course;
  const auto observe = [&](long number) {
    if (!steps.numbers.contains(number)) return true;
    course.moments.push_back({simulation.time(), false, simulation.state(),
                              number == 0 ? std::vector<GrabSpring>() : simulation.springs(), tool_loads(simulation),
                              simulation.contact_forces()});
    return is_finite(course.moments.back().state);
  };
  if (!observe(0)) return std::nullopt;
  for (long number = 1; number <= steps.count; ++number) {
    simulation.step();
    if (stop.stop_requested() || simulation.diverged() || !observe(number)) return std::nullopt;
  }
  if (simulation.check_now()) return std::nullopt;
  return course;
}

}  // namespace

std::optional<Course> GpuSimulator::run(const Scene& scene, const Model& model, const Schedule& schedule) const {
  Scene repeatable = scene;
  repeatable.solver.frame_budget = 0;  // iterations by the clock
  Simulation simulation(std::move(repeatable), model, &programs_, false);
  return schedule.is_static ? equilibria(simulation, schedule, stop_) : motion(simulation, schedule, stop_);
}

}  // namespace fascia
