#include "app/window_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>

#include <algorithm>
#include <utility>

namespace fascia {

using Kind = InputEvent::Kind;

WindowInput& WindowInput::of(GLFWwindow* window) { return *static_cast<WindowInput*>(glfwGetWindowUserPointer(window)); }

void WindowInput::add(InputEvent event) {
  stirred_ = true;
  int window_width = 0, window_height = 0, width = 0, height = 0;
  glfwGetWindowSize(window_, &window_width, &window_height);
  glfwGetFramebufferSize(window_, &width, &height);
  event.at = {at_.x() * width / std::max(1, window_width), at_.y() * height / std::max(1, window_height)};
  events_.push_back(std::move(event));
}

void WindowInput::forward_key(const KeyChange& change) {
  const auto same_key = [&](const KeyChange& other) { return other.key == change.key; };
  if (change.action == GLFW_RELEASE && std::any_of(pressed_.begin(), pressed_.end(), same_key)) {
    deferred_.push_back(change);
    return;
  }
  if (change.action == GLFW_PRESS) pressed_.push_back(change);
  ImGui_ImplGlfw_KeyCallback(window_, change.key, change.scancode, change.action, change.mods);
}

void WindowInput::end_frame() {
  for (const KeyChange& change : deferred_)
    ImGui_ImplGlfw_KeyCallback(window_, change.key, change.scancode, change.action, change.mods);
  deferred_.clear();
  pressed_.clear();
}

WindowInput::WindowInput(GLFWwindow* window) : window_(window) {
  glfwSetWindowUserPointer(window, this);
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    of(w).at_ = {x, y};
    of(w).add({Kind::move});
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
    ImGui_ImplGlfw_MouseButtonCallback(w, button, action, mods);
    of(w).add({action == GLFW_PRESS ? Kind::press : Kind::release, button, mods});
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
    ImGui_ImplGlfw_ScrollCallback(w, x, y);
    InputEvent event{Kind::scroll};
    event.scroll = y;
    for (const int key : {GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL})
      if (glfwGetKey(w, key) == GLFW_PRESS) event.mods |= GLFW_MOD_CONTROL;
    of(w).add(std::move(event));
  });
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
    of(w).stirred_ = true;
    of(w).forward_key({key, scancode, action, mods});
    if (action == GLFW_PRESS || (action == GLFW_REPEAT && key == GLFW_KEY_PERIOD)) of(w).add({Kind::key, key, mods});
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned int character) {
    of(w).stirred_ = true;
    ImGui_ImplGlfw_CharCallback(w, character);
  });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
    of(w).stirred_ = true;
    ImGui_ImplGlfw_WindowFocusCallback(w, focused);
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
    of(w).stirred_ = true;
    ImGui_ImplGlfw_CursorEnterCallback(w, entered);
  });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).stirred_ = true; });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).stirred_ = true; });
  glfwSetWindowIconifyCallback(window, [](GLFWwindow* w, int) { of(w).stirred_ = true; });
  glfwSetWindowCloseCallback(window, [](GLFWwindow* w) { of(w).stirred_ = true; });
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

std::vector<InputEvent> WindowInput::take() { return std::exchange(events_, {}); }

}  // namespace fascia
