#include "sim/simulation/time_error.h"

#include <algorithm>

#include "sim/accuracy/nodal_stress.h"
#include "sim/grab/build_model.h"

namespace fascia {
namespace {

constexpr long kMoments = 10;  // of the run that are compared

// By another integrator than its own if one is given.
struct FinerTime {
  int parts = 1;  // of a substep
  std::optional<Integrator> integrator = std::nullopt;
};

SolverSettings divided(SolverSettings settings, const FinerTime& finer) {
  settings.substeps *= finer.parts;
  settings.integrator = finer.integrator.value_or(settings.integrator);
  return settings;
}

// Results of background work were taken after so many steps of the recorded length; the repetition takes its own.
Replay divided(Replay replay, const FinerTime& finer) {
  std::erase_if(replay.inputs,
                [](const Input& input) { return std::holds_alternative<BackgroundInput>(input.change); });
  replay.timed = false;
  for (Input& input : replay.inputs)
    if (auto* settings = std::get_if<SolverSettings>(&input.change)) *settings = divided(*settings, finer);
  return replay;
}

// None: stopped.
std::optional<Trajectory> repeated(const Simulation& done, const FinerTime& finer, gl::ProgramCache* programs,
                                   const std::stop_token& stop) {
  // The values of the scene and of the model follow the inputs of a replay, which starts with its own.
  Scene scene = done.replay() ? done.replay()->scene : done.scene;
  scene.solver = divided(scene.solver, finer);
  Model model = done.replay() ? build_model(scene) : done.model;
  Simulation run(std::move(scene), std::move(model), programs, done.uses_reference());
  if (done.replay()) run.play(divided(*done.replay(), finer));
  if (!done.uses_reference()) run.gpu()->solve_everything();
  Trajectory motion;
  const long steps = done.steps_made(), moments = std::min(steps, kMoments);
  for (long step = 1; step <= steps; ++step) {
    if (stop.stop_requested()) return std::nullopt;
    run.step();
    const auto passed = static_cast<long>(motion.displacement.size());
    if (step * moments >= (passed + 1) * steps) motion.displacement.push_back(run.state().displacement);
  }
  // The budget of a frame may have granted the run itself other iterations than its repetition.
  const State end = finer.parts == 1 ? done.state() : run.state();
  if (steps > 0) motion.displacement.back() = end.displacement;
  motion.peak_stress = peak_of(nodal_stress(run.model, end, stop), run.model).p99;
  return motion;
}

}  // namespace

bool damps(Integrator integrator) { return integrator != Integrator::sdirk2; }

int order_of(Integrator integrator) { return integrator == Integrator::implicit_euler ? 1 : 2; }

TimeError estimate_time_error(const Simulation& done, gl::ProgramCache* programs, const std::stop_token& stop) {
  TimeExtrapolation extrapolation(order_of(done.scene.solver.integrator));
  for (int parts = 1; extrapolation.wants_more(); parts *= 2) {
    std::optional<Trajectory> motion = repeated(done, {parts}, programs, stop);
    if (!motion) return {.complete = false};
    extrapolation.add(std::move(*motion));
  }
  if (damps(done.scene.solver.integrator)) {
    std::optional<Trajectory> witness = repeated(done, {4, Integrator::sdirk2}, programs, stop);
    if (!witness) return {.complete = false};
    extrapolation.add_witness(std::move(*witness));
  }
  return extrapolation.error();
}

}  // namespace fascia
