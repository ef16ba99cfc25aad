#include "sim/simulation/time_error.h"

#include <algorithm>
#include <cmath>

#include "sim/accuracy/nodal_stress.h"
#include "sim/accuracy/relative_distance.h"
#include "sim/grab/build_model.h"

namespace fascia {
namespace {

SolverSettings halved(SolverSettings settings) {
  settings.substeps *= 2;
  return settings;
}

// Results of background work were taken after so many steps of the recorded length; the repetition takes its own.
Replay halved(Replay replay) {
  std::erase_if(replay.inputs,
                [](const Input& input) { return std::holds_alternative<BackgroundInput>(input.change); });
  replay.timed = false;
  for (Input& input : replay.inputs)
    if (auto* settings = std::get_if<SolverSettings>(&input.change)) *settings = halved(*settings);
  return replay;
}

}  // namespace

int order_of(Integrator integrator) { return integrator == Integrator::implicit_euler ? 1 : 2; }

double richardson_factor(Integrator integrator) {
  const double gain = std::pow(2, order_of(integrator));
  return gain / (gain - 1);
}

TimeError distance_in_time(const Model& model, Integrator integrator, const State& coarse, const State& fine) {
  const double factor = richardson_factor(integrator);
  return {.relative = factor * relative_distance(coarse.displacement, fine.displacement),
          .peak_stress = factor * peak_distance(model, coarse, fine)};
}

TimeError estimate_time_error(const Simulation& done, gl::ProgramCache* programs, const std::stop_token& stop) {
  // The values of the scene and of the model follow the inputs of a replay, which starts with its own.
  Scene scene = done.replay() ? done.replay()->scene : done.scene;
  scene.solver = halved(scene.solver);
  Model model = done.replay() ? build_model(scene) : done.model;
  Simulation finer(std::move(scene), std::move(model), programs, done.uses_reference());
  if (done.replay()) finer.play(halved(*done.replay()));
  if (!done.uses_reference()) finer.gpu()->solve_everything();
  for (long step = 0; step < done.steps_made(); ++step) {
    if (stop.stop_requested()) return {.complete = false};
    finer.step();
  }
  return distance_in_time(done.model, done.scene.solver.integrator, done.state(), finer.state());
}

}  // namespace fascia
