// What keys, mouse and buttons ask of the window.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cmath>

#include "app/opening_screen.h"
#include "app/scene_edits.h"
#include "app/view_window.h"
#include "sim/file.h"

namespace fascia {
namespace fs = std::filesystem;

void ViewWindow::handle_input(Requests& requests) {
  using Kind = InputEvent::Kind;
  const ImGuiIO& io = ImGui::GetIO();
  const MouseTool::Picture picture{framebuffer_->width(), framebuffer_->height()};
  const auto button_of = [](int code) {
    return code == GLFW_MOUSE_BUTTON_LEFT    ? MouseTool::Button::left
           : code == GLFW_MOUSE_BUTTON_RIGHT ? MouseTool::Button::right
                                             : MouseTool::Button::middle;
  };
  for (const InputEvent& event : input_.take()) {
    switch (event.kind) {
      case Kind::press:
        if (!io.WantCaptureMouse && event.code <= GLFW_MOUSE_BUTTON_MIDDLE)
          mouse_.press(button_of(event.code), event.mods & GLFW_MOD_SHIFT, event.at, picture, *session_, state_.grab);
        break;
      case Kind::release: mouse_.release(button_of(event.code), *session_); break;
      case Kind::move: mouse_.move(event.at, picture, *session_); break;
      case Kind::scroll:
        if (!io.WantCaptureMouse) session_->camera.zoom(std::pow(0.9, event.scroll));
        break;
      case Kind::key:
        // With a visible cursor in the panels, keys belong to them; text always does.
        if (!io.WantTextInput && !(io.NavVisible && (event.code == GLFW_KEY_SPACE || event.code == GLFW_KEY_ENTER)))
          press_key(event.code, event.mods, requests);
        break;
      case Kind::drop:
        if (!event.files.empty()) requests.open = event.files.front();
        break;
    }
  }
}

void ViewWindow::press_key(int key, int mods, Requests& requests) {
  if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return;  // a dialog
  if (mods & GLFW_MOD_CONTROL) {
    switch (key) {
      case GLFW_KEY_O: requests.open_dialog = true; break;
      case GLFW_KEY_S: requests.save_dialog = true; break;
      case GLFW_KEY_Q: requests.close = true; break;
    }
    return;
  }
  switch (key) {
    case GLFW_KEY_F: requests.frame_view = true; break;
    case GLFW_KEY_SPACE: state_.paused = !state_.paused; break;
    case GLFW_KEY_PERIOD: requests.step = true; break;
    case GLFW_KEY_R: requests.reset = true; break;
    case GLFW_KEY_W: {
      DisplaySettings display = session_->display();
      display.wireframe = !display.wireframe;
      session_->set_display(display);
      break;
    }
    case GLFW_KEY_H: state_.show_panels = !state_.show_panels; break;
    case GLFW_KEY_P: requests.screenshot = true; break;
    case GLFW_KEY_V: requests.video = true; break;
    case GLFW_KEY_F1: state_.show_help = !state_.show_help; break;
    case GLFW_KEY_F5: requests.reload_shaders = true; break;
  }
}

void ViewWindow::carry_out(const Requests& requests) {
  if (requests.open_dialog) dialogs_.ask_open();
  if (requests.save_dialog) dialogs_.ask_save(session_->simulation.scene.file);
  if (requests.open) open(*requests.open);
  if (requests.save) save(*requests.save);
  if (requests.reset) reset();
  if (requests.step) state_.paused = true;
  if (requests.frame_view) session_->frame();
  if (requests.reload_shaders) reload_shaders();
  if (requests.close) glfwSetWindowShouldClose(graphics_.context->window(), GLFW_TRUE);
}

void ViewWindow::open(const fs::path& path) {
  // The new session is made while the old one still stands: if it cannot be made, nothing has happened.
  Opened input = open_file(path);
  std::unique_ptr<Session> opened = make_session(input);
  mouse_.cancel(*session_);
  state_.convergence.forget();
  session_ = std::move(opened);
  remembered_.reset();
  came_apart_ = 0;
  dialogs_.opened(path);
  state_.facts = SceneFacts(session_->simulation.model);
  state_.statistics = {};
  state_.statistics.measured = true;
  pacing_.restart();
  message_.reset();
  diagnose_ = true;
  set_title();
}

std::unique_ptr<Session> ViewWindow::make_session(Opened& opened) {
  OpeningScreen screen(graphics_, overlay_, opened.scene.file.filename().string());
  const Progress progress = [&](double share, const char* what) { screen.show(share, what); };
  auto session = std::make_unique<Session>(graphics_, std::move(opened.scene), std::move(opened.model), options_.reference, progress);
  if (opened.replay) session->simulation.play(std::move(*opened.replay));
  return session;
}

void ViewWindow::set_title() {
  const Scene& scene = session_->simulation.scene;
  const std::string title = scene.title.empty() ? scene.file.filename().string() : scene.title;
  glfwSetWindowTitle(graphics_.context->window(), (title + " - fascia").c_str());
}

Scene ViewWindow::scene_now() const {
  Scene scene = session_->simulation.scene;
  follow_materials(scene, session_->simulation.model);
  const Camera& camera = session_->camera;
  scene.camera = CameraSettings{camera.eye, camera.target, camera.up, camera.fov_deg};
  return scene;
}

void ViewWindow::save(const fs::path& path) {
  write_file(path, scene_to_json(scene_now(), path.parent_path()));
  dialogs_.opened(path);
  say("Saved " + path.string());
}

void ViewWindow::reset() {
  mouse_.cancel(*session_);
  session_->simulation.reset();
  session_->true_error.forget();
  state_.statistics.steps = 0;
  pacing_.restart();
  diagnose_ = true;
}

void ViewWindow::reload_shaders() {
  std::string text;
  for (const std::string& message : graphics_.programs->reload()) text += (text.empty() ? "" : "\n") + message;
  if (text.empty())
    say("Reloaded " + std::to_string(graphics_.programs->size()) + " programs");
  else
    say(text + "\nThe old code stays in use", true);
}

Provenance ViewWindow::provenance() const {
  Scene scene = session_->simulation.scene;
  follow_materials(scene, session_->simulation.model);
  return provenance_of(scene, session_->simulation.model, session_->renderer_description(), options_.command_line,
                       state_.statistics.steps, session_->simulation.time());
}

void ViewWindow::toggle_video() {
  if (video_.running()) {
    const double seconds = video_.seconds();
    const fs::path path = video_.finish();
    char text[32];
    std::snprintf(text, sizeof text, ", %.1f s", seconds);
    say(path.string() + text);
  } else {
    video_.start(*framebuffer_, provenance());
  }
}

void ViewWindow::capture(const Requests& requests) {
  if (video_.running()) video_.write(*framebuffer_, simulated_);
  if (requests.video) toggle_video();
  if (requests.screenshot) {
    const fs::path path = dated_name(".png");
    write_png(path, framebuffer_->read(), provenance());
    say(path.string());
  }
}

}  // namespace fascia
