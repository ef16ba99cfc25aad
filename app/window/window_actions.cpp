// What keys, mouse and buttons ask of the window.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <atomic>
#include <cmath>
#include <memory>

#include "app/window/opening_screen.h"
#include "app/window/window.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "sim/output/state_export.h"
#include "sim/scene/scene_carry.h"
#include "sim/scene/scene_write.h"
#include "sim/simulation/scene_edits.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

constexpr double kReadShare = 0.4;  // of opening a large scene that goes by before the GPU is needed
constexpr double kResize = 1.1;     // of a grab's patch, per press of a key

// The key as its letter says: Z is elsewhere on other keyboards.
int letter_of(int key) {
  const char* name = glfwGetKeyName(key, 0);
  return name && name[0] >= 'a' && name[0] <= 'z' && name[1] == 0 ? name[0] - 'a' + GLFW_KEY_A : key;
}

}  // namespace

void Window::handle_input(Requests& requests) {
  using Kind = InputEvent::Kind;
  const ImGuiIO& io = ImGui::GetIO();
  const auto button_of = [](int code) {
    return code == GLFW_MOUSE_BUTTON_LEFT    ? MouseTool::Button::left
           : code == GLFW_MOUSE_BUTTON_RIGHT ? MouseTool::Button::right
                                             : MouseTool::Button::middle;
  };
  const auto keys_of = [](int mods) {
    return MouseTool::Keys{(mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_ALT) != 0};
  };
  for (InputEvent event : input_.take()) {
    const bool taken = event.kind == Kind::press && !io.WantCaptureMouse && !mouse_.dragging();
    pointer_ = event.at;
    const MouseTool::Picture picture = to_side(event.at, taken);
    switch (event.kind) {
      case Kind::press:
        if (io.WantCaptureMouse || event.code > GLFW_MOUSE_BUTTON_MIDDLE) break;
        if (event.code == GLFW_MOUSE_BUTTON_LEFT && !split_ && choose_probe(event.at)) break;
        if (event.code == GLFW_MOUSE_BUTTON_LEFT && event.mods & GLFW_MOD_CONTROL && session_->display().section)
          mouse_.press_section(button_of(event.code), event.at);
        else
          mouse_.press(button_of(event.code), keys_of(event.mods), event.at, picture, held(), state_.grab);
        if (!mouse_.grabs().all().empty() && session_->simulation.replaying())
          end_replay("You took over from the replay");
        break;
      case Kind::release:
        mouse_.release(button_of(event.code), keys_of(event.mods), held(), state_.grab);
        break;
      case Kind::move:
        mouse_.move(event.at, picture, held());
        break;
      case Kind::scroll:
        if (!io.WantCaptureMouse && !mouse_.scroll(event.scroll.y(), keys_of(event.mods), held(), state_.grab))
          held().camera.zoom(std::pow(0.9, event.scroll.y()));
        break;
      case Kind::key:
        // With a visible cursor in the panels, keys belong to them; text always does.
        if (!io.WantTextInput && !(panels_take_escape_ && event.code == GLFW_KEY_ESCAPE) &&
            !(io.NavVisible &&
              (event.code == GLFW_KEY_SPACE || event.code == GLFW_KEY_ENTER || event.code == GLFW_KEY_ESCAPE)))
          press_key(event.code, event.mods, requests);
        break;
      case Kind::drop:
        if (!event.files.empty()) requests.open = event.files.front();
        break;
      case Kind::key_up:
      case Kind::text:
        break;
    }
    if (split_) after_mouse();
  }
}

void Window::press_key(int key, int mods, Requests& requests) {
  if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return;  // a dialog
  if (mods & GLFW_MOD_CONTROL) {
    const bool shift = mods & GLFW_MOD_SHIFT;
    const UndoHistory& history = state_.history;
    switch (letter_of(key)) {
      case GLFW_KEY_Z:
        if (shift ? history.can_redo() : history.can_undo()) requests.history = history.done() + (shift ? 1 : -1);
        break;
      case GLFW_KEY_Y:
        if (history.can_redo()) requests.history = history.done() + 1;
        break;
      case GLFW_KEY_C:
        requests.copy_command |= shift;
        break;
      case GLFW_KEY_O:
        (mods & GLFW_MOD_SHIFT ? requests.recent : requests.open_dialog) = true;
        break;
      case GLFW_KEY_E:
        requests.export_dialog = true;
        break;
      case GLFW_KEY_S:
        requests.save_dialog = true;
        break;
      case GLFW_KEY_R:
        requests.save_replay_dialog = true;
        break;
      case GLFW_KEY_Q:
        requests.close = true;
        break;
    }
    return;
  }
  switch (key) {
    case GLFW_KEY_F:
      requests.frame_view = true;
      break;
    case GLFW_KEY_SPACE:
      state_.paused = !state_.paused;
      break;
    case GLFW_KEY_PERIOD:
      requests.step = true;
      break;
    case GLFW_KEY_R:
      requests.reset = true;
      break;
    case GLFW_KEY_W: {
      DisplaySettings display = session_->display();
      display.wireframe = !display.wireframe;
      session_->set_display(display);
      break;
    }
    case GLFW_KEY_H:
      state_.show_panels = !state_.show_panels;
      break;
    case GLFW_KEY_P:
      requests.screenshot = true;
      break;
    case GLFW_KEY_B:
      requests.compare = CompareAsk::open_or_close;
      break;
    case GLFW_KEY_V:
      if (mods & GLFW_MOD_SHIFT)
        state_.show_recording = !state_.show_recording;
      else
        requests.video = true;
      break;
    case GLFW_KEY_T:
      mouse_.stay();
      break;
    case GLFW_KEY_X:
      state_.grab.push = !state_.grab.push;
      break;
    case GLFW_KEY_LEFT_BRACKET:
      mouse_.resize(1 / kResize, held(), state_.grab);
      break;
    case GLFW_KEY_RIGHT_BRACKET:
      mouse_.resize(kResize, held(), state_.grab);
      break;
    case GLFW_KEY_DELETE:
      mouse_.let_go(pointer_in_side(grab_in_b_), picture_of_grab(), held());
      break;
    case GLFW_KEY_ESCAPE:
      if (state_.show_help || state_.show_recording)
        state_.show_help = state_.show_recording = false;
      else
        mouse_.let_go_staying(held());
      break;
    case GLFW_KEY_F1:
      state_.show_help = !state_.show_help;
      break;
    case GLFW_KEY_F2:
      requests.gallery = true;
      break;
    case GLFW_KEY_F3:
      state_.plots.shown = !state_.plots.shown;
      diagnose_ = true;  // for the point
      break;
    case GLFW_KEY_F5:
      requests.reload_shaders = true;
      break;
  }
}

void Window::carry_out(const Requests& requests) {
  if (requests.open_dialog) dialogs_.ask_open(session_->simulation.scene.file);
  if (requests.recent) dialogs_.ask_recent();
  if (requests.export_dialog) dialogs_.ask_export(session_->simulation.scene.file);
  if (requests.gallery) gallery_.ask();
  if (requests.resume) resume(*requests.resume);
  if (requests.resume_recovered && recovered_) resume(fs::path(*recovered_));
  if (requests.forget_recovered && recovered_) {
    fs::remove(*recovered_);
    recovered_.reset();
  }
  if (requests.save_dialog) dialogs_.ask_save(session_->simulation.scene.file);
  if (requests.open) open(*requests.open);
  if (requests.save) save(*requests.save, requests.save_with_mesh);
  if (requests.export_state) export_state(*requests.export_state);
  if (requests.save_replay_dialog) dialogs_.ask_replay();
  if (requests.save_replay) save_replay(*requests.save_replay);
  if (requests.end_replay) end_replay("You took over from the replay");
  if (requests.compare != CompareAsk::nothing) compare(requests.compare);
  if (requests.history) go_through_history(*requests.history);
  if (requests.materials) set_material_entries(*requests.materials);
  if (requests.rescale) rescale(*requests.rescale);
  if (requests.copy_command) copy_command();
  if (requests.reset) reset();
  if (requests.step) state_.paused = true;
  if (requests.frame_view) {
    const Margins edges = margins();
    const double width = framebuffer_->width(), shown = std::max(0.1 * width, width - edges.left - edges.right),
                 aspect = 1.0 / framebuffer_->height();
    if (split_)
      session_->frame_bodies(0.5 * shown * aspect, {1, 1});
    else
      session_->frame_bodies(width * aspect, {shown / width, 1});
    state_.replay_camera = false;
  }
  if (requests.let_go) mouse_.let_go_staying(held());
  if (requests.reload_shaders) reload_shaders();
  if (requests.close) glfwSetWindowShouldClose(graphics_.context->window(), GLFW_TRUE);
}

void Window::open(const fs::path& path) {
  // The new session is made while the old one still stands: if it cannot be made, nothing has happened.
  OpeningScreen screen(graphics_, overlay_, path.filename().string());
  Opened input = read(path, screen);
  take_over(make_session(input, screen, kReadShare));
  dialogs_.opened(path);
}

void Window::resume(const fs::path& path) {
  OpeningScreen screen(graphics_, overlay_, Autosave::name_in(path));
  Opened input = read(path, screen);
  const State state = input.replay && input.replay->start ? *input.replay->start : initial_state(input.model);
  input.replay.reset();
  move_scene(input.scene, fs::current_path() / (Autosave::name_in(path) + ".json"));  // what saving suggests
  std::unique_ptr<Session> opened = make_session(input, screen, kReadShare);
  opened->simulation.go_on_from(state);
  take_over(std::move(opened));
  if (recovered_ == path) {
    recovered_.reset();
    autosave_.replace(path);
  }
  remember();
}

// On another thread, so that the window answers and somebody may think better of it: then reading ends at its next
// report.
Opened Window::read(const fs::path& path, OpeningScreen& screen) {
  constexpr auto kFrame = std::chrono::milliseconds(30);
  std::erase_if(given_up_, [](const std::future<Opened>& f) {
    return f.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  });
  struct Report {
    std::atomic<bool> given_up{false};
    std::atomic<double> share{0};
    std::atomic<const char*> what{nullptr};
  };
  const auto report = std::make_shared<Report>();
  const Progress progress = [report, name = path.filename().string()](double share, const char* what) {
    if (report->given_up) throw Cancelled{name};
    report->share = share;
    report->what = what;
  };
  std::future<Opened> reading =
      std::async(std::launch::async, [path, progress] { return open_file(path, {}, progress); });
  const Clock::time_point start = Clock::now();
  while (reading.wait_for(kFrame) != std::future_status::ready) {
    // How long parsing takes nobody knows: the bar goes on, ever slower.
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count(),
                 guess = 1 - std::exp(-0.3 * seconds);
    const char* const what = report->what;
    try {
      if (interrupted()) throw Cancelled{path.filename().string()};
      screen.show(kReadShare * std::max(0.5 * guess, report->share.load()),
                  (std::string(what ? what : "Reading") + "; Escape goes back").c_str());
    } catch (const Cancelled&) {
      report->given_up = true;
      given_up_.push_back(std::move(reading));
      throw;
    }
  }
  return reading.get();
}

std::unique_ptr<Session> Window::make_session(Opened& opened, OpeningScreen& screen, double share_done) {
  const Progress progress = [&](double share, const char* what) {
    screen.show(share_done + (1 - share_done) * share, what);
  };
  auto session = std::make_unique<Session>(graphics_, std::move(opened.scene), std::move(opened.model),
                                           options_.reference, progress);
  if (opened.replay) session->simulation.play(std::move(*opened.replay));
  return session;
}

void Window::take_over(std::unique_ptr<Session> opened) {
  let_go();
  attempt([&] { end_recording(); });
  split_.reset();
  state_.comparing = state_.editing_b = grab_in_b_ = false;
  state_.convergence.forget();
  state_.plots.forget();
  session_ = std::move(opened);
  message_.reset();
  session_began();
}

void Window::session_began() {
  shown_ = false;
  remembered_.reset();
  divergences_ = 0;
  state_.facts = SceneFacts(session_->simulation.scene, session_->simulation.model);
  state_.statistics = {};
  state_.statistics.measured = true;
  state_.history.restart(tunables_of(*session_, state_.grab));
  opened_camera_ = scene_now().camera;
  pacing_.restart();
  diagnose_ = true;
  set_title();
  begin_replay();
  attempt([&] { begin_recording(); });
}

void Window::set_title() {
  const Scene& scene = session_->simulation.scene;
  const std::string title = scene.title.empty() ? scene.file.filename().string() : scene.title;
  glfwSetWindowTitle(graphics_.context->window(), (title + " - fascia").c_str());
}

Scene Window::scene_now() const {
  Scene scene = session_->simulation.scene;
  follow_materials(scene, session_->simulation.model);
  const Camera& camera = session_->camera;
  scene.camera = CameraSettings{camera.eye, camera.target, camera.up, camera.fov_deg};
  return scene;
}

void Window::save(const fs::path& path, bool with_mesh) {
  std::vector<ReadFile>& files = session_->simulation.model.files;
  const Scene scene = with_mesh ? self_contained(scene_now(), files) : with_known_files(scene_now(), files);
  write_file(path, scene_to_json(scene, path.parent_path()));
  dialogs_.opened(path);
  say("Saved " + path.string());
}

void Window::export_state(const fs::path& path) {
  const Simulation& simulation = session_->simulation;
  write_state(path, simulation.model.file_mesh, reference::export_fields(simulation.model, simulation.state()),
              provenance());
  say("Exported " + path.string());
}

// What somebody has done needs no hint any more.
void Window::follow_hints() {
  const std::vector<Material>& materials = session_->simulation.model.materials;
  if (mouse_.grabs().following()) hints_.done("grab");
  if (mouse_.orbiting()) hints_.done("orbit");
  if (state_.show_help) hints_.done("help");
  if (hints_.wanted("tune") && ImGui::IsAnyItemActive() && tuned_from_.size() == materials.size() &&
      tuned_from_ != materials)
    hints_.done("tune");
  if (hints_.wanted("tune")) tuned_from_ = materials;
}

void Window::reset() {
  let_go();
  // A recording that began in mid-session has its own start, and this one leads elsewhere.
  const bool leaves_recording = !begins_at_start_ && session_->simulation.start();
  if (leaves_recording) leave_recorded_session();
  if (split_)
    split_->reset(*session_);
  else
    session_->simulation.reset();
  if (leaves_recording) {
    attempt([&] { begin_recording(); });
    begins_at_start_ = true;
  }
  session_->true_error.forget();
  state_.statistics.steps = 0;
  pacing_.restart();
  diagnose_ = true;
}

void Window::reload_shaders() {
  std::string text;
  for (const std::string& message : graphics_.programs->reload()) text += (text.empty() ? "" : "\n") + message;
  if (text.empty())
    say("Reloaded " + std::to_string(graphics_.programs->size()) + " programs");
  else
    say(text + "\nThe old code stays in use", true);
}

Provenance Window::provenance() const {
  Scene scene = session_->simulation.scene;
  follow_materials(scene, session_->simulation.model);
  return provenance_of(scene, session_->simulation.model, session_->renderer_description(), options_.command_line,
                       state_.statistics.steps, session_->simulation.time());
}

}  // namespace fascia
