#include "app/refine/trial_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/refine/choice.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "base/text.h"
#include "sim/accuracy/mesh_error.h"
#include "sim/accuracy/trajectory.h"
#include "sim/output/stats.h"
#include "sim/reference/newton.h"
#include "sim/simulation/divergence.h"
#include "sim/simulation/errors/mesh_error_in_motion.h"
#include "sim/simulation/errors/solver_error.h"
#include "sim/simulation/errors/time_error.h"
#include "sim/simulation/simulation.h"

namespace fascia {
namespace {

constexpr long kMoments = 10;  // of a run that are looked at

/// A run of `steps` steps: its motion, and the state with the most elastic energy, whose mesh error counts where that
/// of the run is not known.
struct Run {
  Simulation simulation;
  std::vector<double> ms;
  Trajectory motion;
  State strained;

  Run(const Scene& scene, const Model& model, gl::ProgramCache& programs, long steps)
      : simulation(scene, model, &programs, false) {
    simulation.gpu()->finish_background();
    simulation.gpu()->solve_everything();
    double most = -1;
    const long moments = std::min(steps, kMoments);
    for (long step = 1; step <= steps && !interrupted(); ++step) {
      const auto start = std::chrono::steady_clock::now();
      simulation.step();
      gl::Finish();
      ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
      if (step * moments < (static_cast<long>(motion.displacement.size()) + 1) * steps) continue;
      require_valid(simulation);
      State state = simulation.state();
      motion.displacement.push_back(state.displacement);
      const double energy = reference::measure(simulation.model, state).elastic;
      if (energy <= most) continue;
      most = energy;
      strained = std::move(state);
    }
  }
};

std::size_t kept_tets(const OpenedScene& opened) {
  std::size_t kept = 0;
  for (std::size_t b = 0; b < opened.scene.bodies.size(); ++b)
    if (!opened.scene.bodies[b].resolution) kept += opened.model.bodies[b].tet_count;
  return has_resolution(opened.scene) ? kept : 0;
}

/// A body that is too thick or too thin by a share is too stiff or too soft by that at least.
double shape_error(const Model& model) {
  double most = 0;
  for (const BodyPart& body : model.bodies) most = std::max(most, std::abs(body.filled.value_or(1) - 1));
  return most;
}

/// None: interrupted.
std::optional<Trial> trial_of(const OpenedScene& opened, const TrialRuns& runs, const Proposal& choice,
                              const Trial* alike) {
  const auto& [scene, model] = opened;
  Trial trial;
  trial.elements = choice.elements;
  trial.integrator = choice.integrator;
  trial.refinement = choice.refinement;
  trial.tets = model.tets.size();
  trial.kept = kept_tets(opened);
  trial.shape = shape_error(model);
  trial.substeps = choice.substeps;
  (choice.iterations < trial.many ? trial.few : trial.many) = choice.iterations;
  const auto with = [&, &scene = scene](int iterations) {
    Scene chosen = scene;
    chosen.solver.iterations = iterations;
    return chosen;
  };
  Scene solving = with(trial.many);
  solving.solver = solved(solving.solver);
  const Trajectory exact = Run(solving, model, runs.programs, runs.steps).motion;
  if (interrupted()) return std::nullopt;
  {
    const Run run(with(trial.few), model, runs.programs, runs.steps);
    if (interrupted()) return std::nullopt;
    trial.solver_few = error_of(run.motion, exact).over_run;
    trial.ms_few = percentiles(run.ms).median;
  }
  const Run run(with(trial.many), model, runs.programs, runs.steps);
  if (interrupted()) return std::nullopt;
  trial.solver_many = error_of(run.motion, exact).over_run;
  trial.ms_many = percentiles(run.ms).median;
  if (alike) {
    trial.time = alike->time;
    trial.order = alike->order;
    trial.resolved = alike->resolved;
    trial.mesh = alike->mesh;
    return trial;
  }
  const TimeError in_time = estimate_time_error(run.simulation, &runs.programs);
  trial.time = in_time.over_run;  // at single moments errors of vibrations pass through zero
  trial.order = in_time.order;
  trial.resolved = in_time.resolved;
  const RunError of_mesh = estimate_mesh_error_in_motion(run.simulation, &runs.programs);
  trial.mesh = of_mesh.complete ? of_mesh.over_run : estimate_mesh_error(model, run.strained).displacement;
  return interrupted() ? std::nullopt : std::optional(trial);
}

std::string text_of(const Trial& trial) {
  const std::string substeps = trial.substeps == 1 ? "" : ", " + std::to_string(trial.substeps) + " substeps";
  return std::to_string(trial.tets) + ' ' + name_of(trial.elements) + " tets, " + name_of(trial.integrator) + substeps +
         (trial.shape > 0 ? ": shape " + number(100 * trial.shape) + " %, mesh " : ": mesh ") +
         number(100 * trial.mesh) + " %, time " + number(100 * trial.time) +
         (trial.resolved ? " %" : " % (not resolved)") + ", solver " + number(100 * trial.solver_few) + " % with " +
         std::to_string(trial.few) + " iterations and " + number(100 * trial.solver_many) + " % with " +
         std::to_string(trial.many) + "; " + number(trial.ms_few) + " and " + number(trial.ms_many) + " ms a step";
}

}  // namespace

std::optional<Trial> run_trial(const TrialRuns& runs, const Proposal& choice, const Trial* alike) {
  try {
    const std::optional<Trial> trial = trial_of(runs.open(sets_of(choice, runs.scene)), runs, choice, alike);
    if (trial) runs.say(text_of(*trial));
    return trial;
  } catch (const Error& error) {
    if (choice.refinement == 1) throw;
    runs.say(std::string("left out: ") + error.what());
    return std::nullopt;
  }
}

std::vector<Trial> run_trials(const TrialRuns& runs) {
  std::vector<Trial> trials;
  for (const ElementOrder elements : kElementOrders) {
    if (elements == ElementOrder::quadratic && runs.scene.solver.method != Method::two_level) continue;
    for (const Integrator integrator : {Integrator::implicit_euler, Integrator::bdf2}) {
      Proposal choice;
      choice.elements = elements;
      choice.integrator = integrator;
      choice.substeps = runs.scene.solver.substeps;
      const std::optional<Trial> trial = run_trial(runs, choice);
      if (!trial) return trials;
      trials.push_back(*trial);
    }
  }
  return trials;
}

}  // namespace fascia
