#include "sim/simulation/errors/repeated_run.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "sim/accuracy/nodal_stress.h"
#include "sim/accuracy/refined_bodies.h"
#include "sim/grab/build_model.h"
#include "sim/grab/resolve_grab.h"
#include "sim/simulation/static_equilibrium.h"

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

// The scene of a run at its start, on tets with more freedom.
class OnRefinedTets {
 public:
  OnRefinedTets(const Simulation& done, const ChangedSettings& change, gl::ProgramCache* programs)
      : refined_(refined_bodies(done.model)),
        simulation_(scene_of(done, change), model_of(done), programs, done.uses_reference()) {}

  Simulation& simulation() { return simulation_; }

  std::vector<Eigen::Vector3d> of_own_vertices(const std::vector<Eigen::Vector3d>& displacement) const {
    std::vector<Eigen::Vector3d> own;
    own.reserve(refined_.places.size());
    for (const std::uint32_t place : refined_.places) own.push_back(displacement[place]);
    return own;
  }

 private:
  static Scene scene_of(const Simulation& done, const ChangedSettings& change) {
    Scene scene = done.scene;
    scene.solver = change(scene.solver);
    for (Body& body : scene.bodies) body.elements = ElementOrder::quadratic;
    return scene;
  }
  Model model_of(const Simulation& done) {
    const Scene scene = scene_of(done, std::identity());
    for (std::size_t g = 0; g < scene.grabs.size(); ++g)
      refined_.model.grabs.push_back(resolve_grab(scene, g, refined_.model));
    return std::move(refined_.model);
  }

  RefinedBodies refined_;  // without its model, which the simulation has
  Simulation simulation_;
};

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
  OnRefinedTets refined(done, change, programs);
  std::optional<Trajectory> motion = followed(refined.simulation(), done.steps_made(), std::nullopt, stop);
  if (!motion) return std::nullopt;
  for (std::vector<Eigen::Vector3d>& at_moment : motion->displacement) at_moment = refined.of_own_vertices(at_moment);
  return motion;
}

std::optional<Trajectory> settle_on_refined_tets(const Simulation& done, gl::ProgramCache* programs,
                                                 const std::stop_token& stop) {
  OnRefinedTets refined(done, std::identity(), programs);
  const StaticReport report = refined.simulation().solve_static({}, stop);
  if (stop.stop_requested()) return std::nullopt;
  require_equilibrium(refined.simulation(), report);
  const State state = refined.simulation().state();
  return Trajectory{{refined.of_own_vertices(state.displacement)},
                    peak_beyond_rounding(refined.simulation().model, state, stop)};
}

}  // namespace fascia
