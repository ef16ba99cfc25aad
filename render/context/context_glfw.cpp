// A window with GLFW: the only visible context, and the only one that needs a display.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "base/error.h"
#include "gl/loader.h"
#include "render/context/context.h"
#include "render/context/window_device.h"

namespace fascia {
namespace {

/// GLFW's last message; these have no newline at the end.
std::string glfw_error() {
  const char* message = nullptr;
  const int code = glfwGetError(&message);
  return message ? std::string(message) : "GLFW error " + std::to_string(code);
}

class GlfwContext : public Context {
 public:
  explicit GlfwContext(const ContextRequest& request) {
    if (!glfwInit())
      throw Error(
          "window", "no display: " + glfw_error(),
          "expected a graphical session (DISPLAY or WAYLAND_DISPLAY); without one use render or --context osmesa");
    // A version below 4.3 is created only so that gl::load can report it (macOS ends at 4.1).
    // Not every driver reports a device reset.
    struct Attempt {
      int major, minor, robustness;
    };
    for (const auto& [major, minor, robustness] :
         {Attempt{4, 3, GLFW_LOSE_CONTEXT_ON_RESET}, Attempt{4, 3, GLFW_NO_ROBUSTNESS},
          Attempt{3, 2, GLFW_NO_ROBUSTNESS}}) {
      glfwDefaultWindowHints();
      glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
      glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
      glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
      glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
      glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, request.debug ? GLFW_TRUE : GLFW_FALSE);
      glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, robustness);
      glfwWindowHint(GLFW_DEPTH_BITS, 0);  // all drawing goes to fascia's own framebuffers
      glfwWindowHint(GLFW_STENCIL_BITS, 0);
      window_ = glfwCreateWindow(request.width, request.height, request.title.c_str(), nullptr, nullptr);
      if (window_) return;
    }
    throw Error("window", "no OpenGL core context: " + glfw_error(), "expected OpenGL 4.3");
  }
  // GLFW itself is never terminated: that would unload the driver, which other contexts may still use.
  ~GlfwContext() override { glfwDestroyWindow(window_); }
  GlfwContext(const GlfwContext&) = delete;
  GlfwContext& operator=(const GlfwContext&) = delete;

  std::string name() const override { return "window"; }
  bool is_current() const override { return glfwGetCurrentContext() == window_; }
  GLFWwindow* window() const override { return window_; }
  void make_current() override {
    // Released first: if OSMesa was current in between, GLFW still considers its context bound, and binding it again
    // would have no effect.
    glfwMakeContextCurrent(nullptr);
    glfwMakeContextCurrent(window_);
    gl::load([](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); });
  }

 private:
  GLFWwindow* window_ = nullptr;
};

}  // namespace

std::unique_ptr<Context> make_window_context(const ContextRequest& request) {
  gl::Device wanted;
  if (request.device >= 0) wanted = ask_for_window_device(request.device);
  auto context = std::make_unique<GlfwContext>(request);
  context->make_current();
  const gl::Device came = gl::device();
  if (request.device < 0) {
    context->other_device = other_device_without_window(came);
    context->make_current();
  } else {
    context->other_device = other_device_than(request.device, wanted, came);
  }
  return context;
}

}  // namespace fascia
