#include "app/window/recovery.h"

#include "base/error.h"
#include "gl/loader.h"
#include "sim/scene/scene_write.h"
#include "sim/simulation/divergence.h"

namespace fascia {

void Recovery::session_began() {
  remembered_.reset();
  divergences_ = 0;
}

void Recovery::follow() {
  if (const auto lost = stage_.simulation().diverged()) go_back(*lost);
}

void Recovery::go_back(std::uint32_t lost) {
  constexpr long kForgiven = 600;  // steps; older divergences do not count
  constexpr long kMostTimes = 3;
  Simulation& simulation = stage_.simulation();
  divergences_ = simulation.steps_made() - diverged_at_ > kForgiven ? 1 : divergences_ + 1;
  diverged_at_ = simulation.steps_made();
  sides_.let_go();
  stage_.session->forget_errors();
  stage_.diagnose = true;
  if (divergences_ < kMostTimes) {
    simulation.back_to_valid();
    simulation.begin_anew();
    if (SplitView* split = sides_.split()) split->restart_from(*stage_.session);
    stage_.messages.say("The tissue diverged: back to the last valid state, at rest");
    return;
  }
  stage_.state.paused = true;
  divergences_ = 0;
  try {
    simulation.require_device();
  } catch (const Error& error) {
    return stage_.messages.say(error.what(), true);
  }
  const Divergence divergence = find_divergence(simulation, lost);
  const std::string text =
      divergence.text(simulation.model) + ". Paused at the last valid state; R goes back to the start. ";
  stage_.messages.say(
      text + "More iterations or substeps, or softer tissue, may help; fascia info --device tests the GPU", true);
  stage_.messages.say(text + keep_replay(divergence.replay).string() + " repeats it", true);
}

void Recovery::remember_now_and_then() {
  if (!remembered_ || autosave_.due()) remember();
}

void Recovery::remember() {
  Simulation& simulation = stage_.simulation();
  Scene scene = stage_.scene_now();
  std::string text = parameters_to_json(scene, {});
  const long step = simulation.uses_reference() ? simulation.steps_made() : simulation.gpu()->steps_solved();
  const bool same = remembered_ && step == remembered_step_ && text == remembered_scene_;
  autosave_.wait_a_while();
  if (same) return;
  const std::string name = scene.file.stem().string();
  remembered_ = std::make_shared<const Replay>(
      Replay{std::move(scene), simulation.uses_reference() ? simulation.state() : simulation.last_valid(), {}, 0});
  remembered_scene_ = std::move(text);
  remembered_step_ = step;
  autosave_.keep(remembered_, name);
}

void Recovery::require_device() const {
  try {
    gl::require_context();
  } catch (const gl::ContextLost& lost) {
    if (!remembered_) throw;
    throw gl::ContextLost(std::string(lost.what()) + ". The scene is kept in " + keep_replay(*remembered_).string());
  }
}

void Recovery::look_for_left() { left_ = autosave_.left_behind(); }

void Recovery::forget_left() {
  if (!left_) return;
  std::filesystem::remove(*left_);
  left_.reset();
}

void Recovery::resumed(const std::filesystem::path& file) {
  if (left_ == file) {
    left_.reset();
    autosave_.replace(file);
  }
  remember();
}

}  // namespace fascia
