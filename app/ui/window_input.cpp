#include "app/ui/window_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

namespace fascia {
namespace {

using Kind = InputEvent::Kind;

constexpr int kSettlingFrames = 4;  // a dialog is requested, opened, measured, and shown with its field active

// Whether several events of this kind in a row can be processed in one frame of ImGui without loss.
bool merges(Kind kind) {
  return kind == Kind::move || kind == Kind::scroll || kind == Kind::text || kind == Kind::key_up;
}

bool unsettles(Kind kind) { return kind == Kind::press || kind == Kind::release || kind == Kind::key; }

}  // namespace

WindowInput& WindowInput::of(GLFWwindow* window) {
  return *static_cast<WindowInput*>(glfwGetWindowUserPointer(window));
}

Eigen::Vector2d WindowInput::pixel(const Eigen::Vector2d& at) const {
  int window_width = 0, window_height = 0, width = 0, height = 0;
  glfwGetWindowSize(window_, &window_width, &window_height);
  glfwGetFramebufferSize(window_, &width, &height);
  return {at.x() * width / std::max(1, window_width), at.y() * height / std::max(1, window_height)};
}

void WindowInput::add(InputEvent event) {
  woken_ = true;
  event.at = pixel(at_);
  waiting_.push_back(std::move(event));
}

void WindowInput::give(const InputEvent& event) {
  given_at_ = event.at;
  const auto button = static_cast<std::size_t>(event.code);
  switch (event.kind) {
    case Kind::press:
    case Kind::release:
      if (button < given_down_.size()) given_down_[button] = event.kind == Kind::press;
      break;
    case Kind::scroll:
      ImGui_ImplGlfw_ScrollCallback(window_, event.scroll.x(), event.scroll.y());
      break;
    case Kind::key:
      // Without a keyboard cursor in the panels, Tab belongs to the scene; ImGui would go to a field of the panels.
      if (event.code == GLFW_KEY_TAB && !(event.mods & GLFW_MOD_CONTROL) && !ImGui::GetIO().WantTextInput &&
          !ImGui::GetIO().NavVisible)
        break;
      ImGui_ImplGlfw_KeyCallback(window_, event.code, 0, GLFW_PRESS, event.mods);
      break;
    case Kind::key_up:
      ImGui_ImplGlfw_KeyCallback(window_, event.code, 0, GLFW_RELEASE, event.mods);
      break;
    case Kind::text:
      ImGui_ImplGlfw_CharCallback(window_, static_cast<unsigned int>(event.code));
      break;
    case Kind::move:
    case Kind::drop:
      break;
  }
}

void WindowInput::feed() {
  ImGuiIO& io = ImGui::GetIO();
  const bool inside = io.MousePos.x > -FLT_MAX || waiting();
  if (settling_ > 0) {
    --settling_;
  } else if (waiting()) {
    const Kind kind = waiting_.front().kind;
    do {
      give(waiting_.front());
      given_.push_back(std::move(waiting_.front()));
      waiting_.pop_front();
    } while (waiting() && waiting_.front().kind == kind && merges(kind));
    if (unsettles(kind)) settling_ = kSettlingFrames;
  }
  // ImGui's own backend has used the current state of mouse and buttons instead.
  if (inside) io.MousePos = {static_cast<float>(given_at_.x()), static_cast<float>(given_at_.y())};
  for (std::size_t i = 0; i < given_down_.size(); ++i) io.MouseDown[i] = given_down_[i];
}

std::vector<InputEvent> WindowInput::take() { return std::exchange(given_, {}); }

bool WindowInput::take_key(int key) {
  if (!waiting() || waiting_.front().kind != Kind::key || waiting_.front().code != key) return false;
  waiting_.pop_front();
  return true;
}

void WindowInput::discard() {
  std::erase_if(waiting_,
                [](const InputEvent& event) { return event.kind != Kind::release && event.kind != Kind::key_up; });
  given_.clear();
}

WindowInput::WindowInput(GLFWwindow* window) : window_(window) {
  glfwSetWindowUserPointer(window, this);
  glfwGetCursorPos(window, &at_.x(), &at_.y());
  given_at_ = pixel(at_);
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    of(w).at_ = {x, y};
    of(w).add({Kind::move});
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
    of(w).add({action == GLFW_PRESS ? Kind::press : Kind::release, button, mods});
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
    InputEvent event{Kind::scroll};
    event.scroll = {x, y};
    for (const auto& [key, mod] : {std::pair{GLFW_KEY_LEFT_CONTROL, GLFW_MOD_CONTROL},
                                   {GLFW_KEY_RIGHT_CONTROL, GLFW_MOD_CONTROL},
                                   {GLFW_KEY_LEFT_ALT, GLFW_MOD_ALT},
                                   {GLFW_KEY_RIGHT_ALT, GLFW_MOD_ALT}})
      if (glfwGetKey(w, key) == GLFW_PRESS) event.mods |= mod;
    of(w).add(std::move(event));
  });
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int mods) {
    of(w).woken_ = true;
    // A key that is held down repeats steps as fast as they are made.
    if (action == GLFW_REPEAT && (key != GLFW_KEY_PERIOD || of(w).waiting())) return;
    of(w).add({action == GLFW_RELEASE ? Kind::key_up : Kind::key, key, mods});
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned int character) {
    of(w).add({Kind::text, static_cast<int>(character)});
  });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
    of(w).woken_ = true;
    ImGui_ImplGlfw_WindowFocusCallback(w, focused);
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
    of(w).woken_ = true;
    ImGui_ImplGlfw_CursorEnterCallback(w, entered);
  });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).woken_ = true; });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).woken_ = true; });
  glfwSetWindowIconifyCallback(window, [](GLFWwindow* w, int) { of(w).woken_ = true; });
  glfwSetWindowCloseCallback(window, [](GLFWwindow* w) { of(w).woken_ = true; });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    InputEvent event{Kind::drop};
    event.files.assign(paths, paths + count);
    of(w).add(std::move(event));
  });
}

WindowInput::~WindowInput() {
  glfwSetCursorPosCallback(window_, nullptr);
  glfwSetMouseButtonCallback(window_, nullptr);
  glfwSetScrollCallback(window_, nullptr);
  glfwSetKeyCallback(window_, nullptr);
  glfwSetCharCallback(window_, nullptr);
  glfwSetWindowFocusCallback(window_, nullptr);
  glfwSetCursorEnterCallback(window_, nullptr);
  glfwSetDropCallback(window_, nullptr);
  glfwSetWindowRefreshCallback(window_, nullptr);
  glfwSetFramebufferSizeCallback(window_, nullptr);
  glfwSetWindowIconifyCallback(window_, nullptr);
  glfwSetWindowCloseCallback(window_, nullptr);
}

}  // namespace fascia
