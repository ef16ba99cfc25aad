#include "sim/simulation/errors/repeated_run.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "sim/accuracy/nodal_stress.h"
#include "sim/accuracy/refined_bodies.h"
#include "sim/grab/build_model.h"
#include "sim/grab/resolve_grab.h"

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

// The motion of a run that has yet to make its steps. `end`: instead of the state after the last one.
std::optional<Trajectory> followed(Simulation& run, long steps, const std::optional<State>& end,
                                   const std::stop_token& stop) {
  if (!run.uses_reference()) run.gpu()->solve_everything();
  Trajectory motion;
  const long moments = std::min(steps, kMoments);
  for (long step = 1; step <= steps; ++step) {
    if (stop.stop_requested()) return std::nullopt;
    run.step();
    const auto passed = static_cast<long>(motion.displacement.size());
    if (step * moments >= (passed + 1) * steps) motion.displacement.push_back(run.state().displacement);
  }
  const State last = end ? *end : run.state();
  if (steps > 0) motion.displacement.back() = last.displacement;
  motion.peak_stress = peak_beyond_rounding(run.model, last, stop);
  return motion;
}

std::optional<Trajectory> repeated(const Simulation& done, const ChangedSettings& change,
                                   const std::optional<State>& end, gl::ProgramCache* programs,
                                   const std::stop_token& stop) {
  // The values of the scene and of the model follow the inputs of a replay, which starts with its own.
  Scene scene = done.replay() ? done.replay()->scene : done.scene;
  scene.solver = change(scene.solver);
  Model model = done.replay() ? build_model(scene) : done.model;
  Simulation run(std::move(scene), std::move(model), programs, done.uses_reference());
  if (done.replay()) run.play(changed(*done.replay(), change));
  return followed(run, done.steps_made(), end, stop);
}

}  // namespace

std::optional<Trajectory> repeat_run(const Simulation& done, const ChangedSettings& change, gl::ProgramCache* programs,
                                     const std::stop_token& stop) {
  return repeated(done, change, std::nullopt, programs, stop);
}

std::optional<Trajectory> repeat_run(const Simulation& done, gl::ProgramCache* programs, const std::stop_token& stop) {
  return repeated(done, std::identity(), done.state(), programs, stop);
}

std::optional<Trajectory> repeat_on_refined_tets(const Simulation& done, const ChangedSettings& change,
                                                 gl::ProgramCache* programs, const std::stop_token& stop) {
  RefinedBodies refined = refined_bodies(done.model);
  Scene scene = done.scene;
  scene.solver = change(scene.solver);
  for (Body& body : scene.bodies) body.elements = ElementOrder::quadratic;
  for (std::size_t g = 0; g < scene.grabs.size(); ++g)
    refined.model.grabs.push_back(resolve_grab(scene, g, refined.model));
  Simulation run(std::move(scene), std::move(refined.model), programs, done.uses_reference());
  std::optional<Trajectory> motion = followed(run, done.steps_made(), std::nullopt, stop);
  if (!motion) return std::nullopt;
  for (std::vector<Eigen::Vector3d>& at_moment : motion->displacement) {
    std::vector<Eigen::Vector3d> own(refined.places.size());
    for (std::size_t v = 0; v < own.size(); ++v) own[v] = at_moment[refined.places[v]];
    at_moment = std::move(own);
  }
  return motion;
}

}  // namespace fascia
