#include "sim/simulation/repeated_run.h"

#include <algorithm>

#include "sim/accuracy/nodal_stress.h"
#include "sim/grab/build_model.h"

namespace fascia {
namespace {

constexpr long kMoments = 10;  // of the run that are compared

// Results of background work were taken after so many steps of the recorded length; the repetition takes its own.
Replay changed(Replay replay, const ChangedSettings& change) {
  std::erase_if(replay.inputs,
                [](const Input& input) { return std::holds_alternative<BackgroundInput>(input.change); });
  replay.timed = false;
  for (Input& input : replay.inputs)
    if (auto* settings = std::get_if<SolverSettings>(&input.change)) *settings = change(*settings);
  return replay;
}

std::optional<Trajectory> repeated(const Simulation& done, const ChangedSettings& change, bool to_its_end,
                                   gl::ProgramCache* programs, const std::stop_token& stop) {
  // The values of the scene and of the model follow the inputs of a replay, which starts with its own.
  Scene scene = done.replay() ? done.replay()->scene : done.scene;
  scene.solver = change(scene.solver);
  Model model = done.replay() ? build_model(scene) : done.model;
  Simulation run(std::move(scene), std::move(model), programs, done.uses_reference());
  if (done.replay()) run.play(changed(*done.replay(), change));
  if (!done.uses_reference()) run.gpu()->solve_everything();
  Trajectory motion;
  const long steps = done.steps_made(), moments = std::min(steps, kMoments);
  for (long step = 1; step <= steps; ++step) {
    if (stop.stop_requested()) return std::nullopt;
    run.step();
    const auto passed = static_cast<long>(motion.displacement.size());
    if (step * moments >= (passed + 1) * steps) motion.displacement.push_back(run.state().displacement);
  }
  const State end = to_its_end ? done.state() : run.state();
  if (steps > 0) motion.displacement.back() = end.displacement;
  motion.peak_stress = peak_of(nodal_stress(run.model, end, stop), run.model).p99;
  return motion;
}

}  // namespace

std::optional<Trajectory> repeat_run(const Simulation& done, const ChangedSettings& change, gl::ProgramCache* programs,
                                     const std::stop_token& stop) {
  return repeated(done, change, false, programs, stop);
}

std::optional<Trajectory> repeat_run(const Simulation& done, gl::ProgramCache* programs, const std::stop_token& stop) {
  return repeated(done, std::identity(), true, programs, stop);
}

}  // namespace fascia
