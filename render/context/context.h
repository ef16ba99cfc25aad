// A current OpenGL 4.3 core context, however it was made. One implementation file per kind: context_glfw,
// context_osmesa, context_egl. Drawing goes to our own framebuffers everywhere, so the context's own surface
// can be tiny.
#pragma once
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace fascia {

/// What was made in a context must be destroyed while that context lives and is current. The end of a context
/// leaves none current.
class Context {
 public:
  virtual ~Context() = default;
  virtual void make_current() = 0;       // also points the gl:: functions at this context
  virtual std::string name() const = 0;  // "window", "egl", "osmesa"
  virtual GLFWwindow* window() const { return nullptr; }
};

struct ContextRequest {
  std::string name = "auto";  // auto, window, egl, osmesa
  bool for_view = false;  // auto takes the window then; else EGL on a GPU, else OSMesa, else EGL on software
  int width = 1280, height = 720;
  std::string title = "fascia";
  bool debug = false;  // KHR_debug output, synchronous
};

/// Made current and loaded (gl::load). Throws Error with what was tried and why each failed, or what compute
/// support is missing.
std::unique_ptr<Context> make_context(const ContextRequest& request);

// What make_context tries; each throws Error when it cannot.
std::unique_ptr<Context> make_window_context(const ContextRequest& request);
std::unique_ptr<Context> make_osmesa_context(const ContextRequest& request);
enum class EglDevices { hardware_only, any };  // the device platform first, then surfaceless
std::unique_ptr<Context> make_egl_context(const ContextRequest& request, EglDevices devices);

}  // namespace fascia
