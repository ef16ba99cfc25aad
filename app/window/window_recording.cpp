// The window's sessions, replays and videos.
#include <cstdio>

#include "app/window/window.h"
#include "base/dated_name.h"
#include "base/error.h"
#include "sim/scene/scene_carry.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

// [bytes] of meshes that a session has in its file from its first moment: what takes longer waits until it is saved.
constexpr std::uint64_t kCarriedFromTheStart = 32 << 20;

CameraSettings settings_of(const Camera& camera) { return {camera.eye, camera.target, camera.up, camera.fov_deg}; }

}  // namespace

void Window::begin_recording() {
  Simulation& simulation = session_->simulation;
  recording_.reset();
  if (options_.steps || options_.time) return;  // a scripted window remembers nothing
  // A static equilibrium has more digits than the state that steps go on from.
  if (options_.static_equilibrium) return;
  const fs::path path = session_file();
  if (path.empty()) return;
  recorded_from_ = simulation.steps_made();
  Replay beginning{
      self_contained_if_possible(scene_now(), simulation.model.files, kCarriedFromTheStart), simulation.start(), {}, 0};
  const bool gone_on_from = simulation.time() != (beginning.start ? beginning.start->time : 0);
  begins_at_start_ = recorded_from_ == 0 && !gone_on_from;
  if (!begins_at_start_) beginning.start = simulation.go_on_as_replay();
  for (auto& entry : provenance())
    if (entry.first != "Parameters" && entry.first != "Title" && entry.first != "Moment")
      beginning.made_by.push_back(std::move(entry));
  recording_ = std::make_unique<SessionRecording>(path, std::move(beginning));
  simulation.set_listener([this](const Input& input) {
    if (recording_) recording_->add({input.step - recorded_from_, input.change});
  });
}

void Window::follow_recording() {
  if (!recording_) return;
  const long steps = session_->simulation.steps_made() - recorded_from_;
  recording_->look(steps, settings_of(session_->camera), session_->display());
  recording_->breathe(steps);
}

void Window::end_recording() {
  if (!recording_) return;
  follow_recording();
  recording_->note_state(session_->simulation.steps_made() - recorded_from_, state_hash(session_->simulation.state()));
}

// With nothing held, so that another recording may go on from here.
void Window::leave_recorded_session() {
  mouse_.end_drag(held());
  end_replay("You took over from the replay");
  session_->simulation.set_grab({});
  if (split_) split_->b().simulation.set_grab({});
  attempt([&] { end_recording(); });
  session_->simulation.set_listener({});
}

void Window::record_anew() {
  attempt([&] { begin_recording(); });
  mouse_.hold(held());
  if (split_) lead();
}

void Window::save_replay(const fs::path& path) {
  if (!recording_)
    throw Error(
        path.string(), "this session is not recorded",
        "expected neither --steps, --time nor --static, and a folder for the state of programs (XDG_STATE_HOME)");
  end_recording();
  const bool whole = recording_->carry_files(session_->simulation.model.files);
  recording_->save_as(path);
  say("Saved " + path.string() + (whole ? "" : ", without its mesh, which has changed or is too large") +
      ". fascia render --replay makes a video of it");
}

void Window::begin_replay() {
  const Simulation& simulation = session_->simulation;
  replay_view_ = simulation.replay() ? ReplayView(*simulation.replay()) : ReplayView();
  replayed_display_.reset();
  state_.replay_speed = 1;
  state_.replay_camera = true;
}

void Window::follow_replay() {
  Simulation& simulation = session_->simulation;
  if (!simulation.replay()) return;
  if (!simulation.replaying()) {
    end_replay("The replay is over: the tissue is yours");
    return;
  }
  const auto step = static_cast<double>(simulation.replayed_steps());
  if (const auto camera = replay_view_.camera(step); camera && state_.replay_camera) session_->look_from(*camera);
  if (const auto display = replay_view_.display(step); display && display != replayed_display_) {
    replayed_display_ = display;
    session_->set_display(*display);
    accept_tunables();
  }
}

void Window::end_replay(const std::string& news) {
  Simulation& simulation = session_->simulation;
  const bool was_played = simulation.replay() && simulation.replay()->steps > 0;
  simulation.end_replay();
  if (mouse_.grabs().all().empty()) simulation.set_grab({});
  if (was_played && !message_) say(news);
}

void Window::toggle_video() {
  if (!video_.running()) {
    video_.start(state_.video, *framebuffer_, provenance());
    return;
  }
  char text[64];
  std::snprintf(text, sizeof text, ", %.1f s", video_.seconds());
  std::string news = text;
  if (video_.dropped() > 0)
    news += ", " + std::to_string(video_.dropped()) + (video_.dropped() == 1 ? " frame" : " frames") + " dropped";
  const fs::path path = video_.finish();
  say(path.string() + news);
}

void Window::record_frame() {
  if (!video_.advance(simulated_)) return;
  Framebuffer& canvas = video_.canvas(*framebuffer_, state_.show_panels);
  if (&canvas != framebuffer_.get()) {
    const bool panels = video_.settings().panels;
    const float scale = overlay_.scale_onto(canvas);
    const int left = panels ? static_cast<int>(scale * static_cast<float>(panels_cover())) : 0;
    const Camera in_window = session_->camera, in_window_b = split_ ? split_->b().camera : in_window;
    if (split_)
      draw_comparison(canvas, scale, left);
    else
      draw_scene(canvas, scale, left);
    session_->camera = in_window;
    if (split_) split_->b().camera = in_window_b;
    overlay_.draw_onto(canvas, panels);
  }
  video_.write(canvas);
}

void Window::capture(const Requests& requests) {
  if (video_.running()) record_frame();
  if (requests.video) toggle_video();
  write_plots(requests);
  if (requests.screenshot) {
    const fs::path path = dated_name(".png");
    write_png(path, framebuffer_->read(), provenance());
    say(path.string());
  }
}

}  // namespace fascia
