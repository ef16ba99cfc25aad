// A current OpenGL 4.3 core context, however it was made, and the two kinds that need no window: EGL and OSMesa. One
// implementation file per kind; the window's is render/context. Drawing goes to our own framebuffers everywhere, so the
// context's own surface can be tiny.
#pragma once
#include <memory>
#include <string>

struct GLFWwindow;

namespace fascia {

/// What was made in a context must be destroyed while that context lives and is current. The end of a context
/// leaves none current.
class Context {
 public:
  virtual ~Context() = default;
  virtual void make_current() = 0;       // also points the gl:: functions at this context
  virtual bool is_current() const = 0;   // on the calling thread, whatever the gl:: functions point at
  virtual std::string name() const = 0;  // "window", "egl", "osmesa"
  virtual GLFWwindow* window() const { return nullptr; }
};

struct ContextRequest {
  std::string name = "auto";  // auto, window, egl, osmesa
  bool for_view = false;      // auto takes the window then; else EGL on a GPU, else OSMesa, else EGL on software
  int width = 1280, height = 720;
  std::string title = "fascia";
  bool debug = false;  // KHR_debug output, synchronous
};

/// auto, egl or osmesa. Made current and loaded (gl::load). Throws Error with what was tried and why each failed, or
/// what compute support is missing.
std::unique_ptr<Context> make_headless_context(const ContextRequest& request);

// What make_headless_context tries; each throws Error when it cannot.
std::unique_ptr<Context> make_osmesa_context(const ContextRequest& request);
enum class EglDevices { hardware_only, any };  // the device platform first, then surfaceless
std::unique_ptr<Context> make_egl_context(const ContextRequest& request, EglDevices devices);

}  // namespace fascia
