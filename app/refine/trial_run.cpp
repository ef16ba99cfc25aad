#include "app/refine/trial_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/interrupt.h"
#include "base/text.h"
#include "sim/accuracy/mesh_error.h"
#include "sim/accuracy/relative_distance.h"
#include "sim/grab/build_model.h"
#include "sim/output/stats.h"
#include "sim/reference/newton.h"
#include "sim/simulation/divergence.h"
#include "sim/simulation/errors/mesh_error_in_motion.h"
#include "sim/simulation/errors/time_error.h"
#include "sim/simulation/simulation.h"

namespace fascia {
namespace {

// Iterations whose steps count as exact, in those of the trial: they reach float32.
constexpr int kSolved = 3;

/// A run of `steps` steps: the state with the most elastic energy, whose mesh error counts where that of the run is not
/// known.
struct Run {
  Simulation simulation;
  std::vector<double> ms;
  State strained;

  Run(const Scene& scene, const Model& model, gl::ProgramCache& programs, long steps)
      : simulation(scene, model, &programs, false) {
    simulation.gpu()->finish_background();
    simulation.gpu()->solve_everything();
    double most = -1;
    const long interval = std::max(1L, steps / 10);
    for (long step = 1; step <= steps && !interrupted(); ++step) {
      const auto start = std::chrono::steady_clock::now();
      simulation.step();
      gl::Finish();
      ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
      if (step % interval != 0) continue;
      require_valid(simulation);
      State state = simulation.state();
      const double energy = reference::measure(simulation.model, state).elastic;
      if (energy <= most) continue;
      most = energy;
      strained = std::move(state);
    }
  }
};

Trial trial_of(const Scene& scene, const Model& model, gl::ProgramCache& programs, long steps) {
  Trial trial;
  trial.elements = scene.bodies.front().elements;
  trial.integrator = scene.solver.integrator;
  trial.tets = model.tets.size();
  trial.substeps = scene.solver.substeps;
  const auto with = [&](int iterations) {
    Scene chosen = scene;
    chosen.solver.iterations = iterations;
    return chosen;
  };
  const auto solved = Run(with(kSolved * trial.many), model, programs, steps).simulation.state().displacement;
  {
    const Run run(with(trial.few), model, programs, steps);
    trial.solver_few = relative_distance(run.simulation.state().displacement, solved);
    trial.ms_few = percentiles(run.ms).median;
  }
  const Run run(with(trial.many), model, programs, steps);
  trial.solver_many = relative_distance(run.simulation.state().displacement, solved);
  trial.ms_many = percentiles(run.ms).median;
  const TimeError in_time = estimate_time_error(run.simulation, &programs);
  trial.time = in_time.over_run;  // at single moments errors of vibrations pass through zero
  trial.order = in_time.order;
  trial.resolved = in_time.resolved;
  const RunError of_mesh = estimate_mesh_error_in_motion(run.simulation, &programs);
  trial.mesh = of_mesh.complete ? of_mesh.over_run : estimate_mesh_error(model, run.strained).displacement;
  return trial;
}

}  // namespace

Trial run_trial(const Scene& scene, gl::ProgramCache& programs, long steps, const Proposal& choice,
                const std::function<void(const std::string&)>& say) {
  Scene chosen = scene;
  for (Body& body : chosen.bodies) body.elements = choice.elements;
  chosen.solver.integrator = choice.integrator;
  chosen.solver.substeps = choice.substeps;
  const Trial trial = trial_of(chosen, build_model(chosen), programs, steps);
  if (interrupted()) return trial;
  const std::string substeps = trial.substeps == 1 ? "" : ", " + std::to_string(trial.substeps) + " substeps";
  say(std::to_string(trial.tets) + ' ' + name_of(trial.elements) + " tets, " + name_of(trial.integrator) + substeps +
      ": mesh " + number(100 * trial.mesh) + " %, time " + number(100 * trial.time) +
      (trial.resolved ? " %" : " % (not resolved)") + ", solver " + number(100 * trial.solver_few) + " % with " +
      std::to_string(trial.few) + " iterations and " + number(100 * trial.solver_many) + " % with " +
      std::to_string(trial.many) + "; " + number(trial.ms_few) + " and " + number(trial.ms_many) + " ms a step");
  return trial;
}

std::vector<Trial> run_trials(const Scene& scene, gl::ProgramCache& programs, long steps,
                              const std::function<void(const std::string&)>& say) {
  std::vector<Trial> trials;
  for (const ElementOrder elements : kElementOrders) {
    if (elements == ElementOrder::quadratic && scene.solver.method != Method::two_level) continue;
    for (const Integrator integrator : {Integrator::implicit_euler, Integrator::bdf2}) {
      Proposal choice;
      choice.elements = elements;
      choice.integrator = integrator;
      choice.substeps = scene.solver.substeps;
      const Trial trial = run_trial(scene, programs, steps, choice, say);
      if (interrupted()) return trials;
      trials.push_back(trial);
    }
  }
  return trials;
}

}  // namespace fascia
