#include "app/window/recording_control.h"

#include "base/error.h"
#include "sim/scene/scene_carry.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

// [bytes] of meshes that a session writes to its file at the start. Larger meshes are written when the session is
// saved, because writing them takes long.
constexpr std::uint64_t kCarriedFromTheStart = 32 << 20;

CameraSettings settings_of(const Camera& camera) { return {camera.eye, camera.target, camera.up, camera.fov_deg}; }

}  // namespace

void RecordingControl::session_began() {
  begin_replay();
  stage_.messages.attempt([&] { begin(); });
}

void RecordingControl::begin() {
  Simulation& simulation = stage_.simulation();
  recording_.reset();
  if (!enabled_) return;
  const fs::path path = session_file();
  if (path.empty()) return;
  recorded_from_ = simulation.steps_made();
  Replay beginning{self_contained_if_possible(stage_.scene_now(), simulation.model.files, kCarriedFromTheStart),
                   simulation.start(),
                   {},
                   0};
  const bool gone_on_from = simulation.time() != (beginning.start ? beginning.start->time : 0);
  begins_at_start_ = recorded_from_ == 0 && !gone_on_from;
  if (!begins_at_start_) beginning.start = simulation.go_on_as_replay();
  for (auto& entry : stage_.provenance())
    if (entry.first != "Parameters" && entry.first != "Title" && entry.first != "Moment")
      beginning.made_by.push_back(std::move(entry));
  recording_ = std::make_unique<SessionRecording>(path, std::move(beginning));
  simulation.set_listener([this](const Input& input) {
    if (recording_) recording_->add({input.step - recorded_from_, input.change});
  });
}

void RecordingControl::follow() {
  if (!recording_) return;
  const long steps = stage_.simulation().steps_made() - recorded_from_;
  recording_->look(steps, settings_of(stage_.session->camera), stage_.session->display());
  recording_->breathe(steps);
}

void RecordingControl::end() {
  if (!recording_) return;
  follow();
  recording_->note_state(stage_.simulation().steps_made() - recorded_from_, state_hash(stage_.simulation().state()));
}

void RecordingControl::save(const fs::path& path) {
  if (!recording_)
    throw Error(
        path.string(), "this session is not recorded",
        "expected neither --steps, --time nor --static, and a folder for the state of programs (XDG_STATE_HOME)");
  end();
  const bool whole = recording_->carry_files(stage_.simulation().model.files);
  recording_->save_as(path);
  stage_.messages.say("Saved " + path.string() +
                      (whole ? "" : ", without its mesh, which has changed or is too large") +
                      ". fascia render --replay makes a video of it");
}

// Releases all grabs, so that a later recording can start from this state.
void RecordingControl::leave() {
  sides_.end_drag();
  take_over_replay();
  sides_.release();
  stage_.messages.attempt([&] { end(); });
  stage_.simulation().set_listener({});
}

void RecordingControl::begin_anew_around(const std::function<void()>& change) {
  leave();
  change();
  stage_.messages.attempt([&] { begin(); });
  sides_.hold();
}

// A recording that began in mid-session has its own start, which differs from the start of the scene.
void RecordingControl::reset_around(const std::function<void()>& reset) {
  const bool other_start = !begins_at_start_ && stage_.simulation().start();
  if (other_start) leave();
  reset();
  if (!other_start) return;
  stage_.messages.attempt([&] { begin(); });
  begins_at_start_ = true;
}

void RecordingControl::begin_replay() {
  const Simulation& simulation = stage_.simulation();
  replay_view_ = simulation.replay() ? ReplayView(*simulation.replay()) : ReplayView();
  replayed_display_.reset();
  stage_.state.replay_speed = 1;
  stage_.state.replay_camera = true;
}

void RecordingControl::follow_replay() {
  Simulation& simulation = stage_.simulation();
  if (!simulation.replay()) return;
  if (!simulation.replaying()) {
    end_replay("The replay is over: the tissue can be grabbed");
    return;
  }
  const auto step = static_cast<double>(simulation.replayed_steps());
  if (const auto camera = replay_view_.camera(step); camera && stage_.state.replay_camera)
    stage_.session->look_from(*camera);
  if (const auto display = replay_view_.display(step); display && display != replayed_display_) {
    replayed_display_ = display;
    stage_.session->set_display(*display);
    sides_.accept_tunables_of_a();
  }
}

void RecordingControl::end_replay(const std::string& news) {
  Simulation& simulation = stage_.simulation();
  const bool was_played = simulation.replay() && simulation.replay()->steps > 0;
  simulation.end_replay();
  if (stage_.mouse.grabs().all().empty()) simulation.set_grab({});
  if (was_played && !stage_.messages.any()) stage_.messages.say(news);
}

}  // namespace fascia
