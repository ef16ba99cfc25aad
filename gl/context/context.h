// A current OpenGL 4.3 core context of any kind, and the two kinds that need no window: EGL and OSMesa. One
// implementation file per kind; the window's is in render/context. All drawing goes to fascia's own framebuffers, so
// the context's own surface can be tiny.
#pragma once
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace fascia {

/// Objects of a context must be destroyed while that context exists and is current. Destroying a context leaves none
/// current.
class Context {
 public:
  virtual ~Context() = default;
  virtual void make_current() = 0;       // also points the gl:: functions at this context
  virtual bool is_current() const = 0;   // on the calling thread, regardless of the gl:: functions
  virtual std::string name() const = 0;  // "window", "egl", "osmesa"
  virtual GLFWwindow* window() const { return nullptr; }

  /// Why auto took none of the GPUs that the system shows; empty if it shows none, or one was taken.
  std::string passed_over{};
  /// Of a window: that another device draws it than the one that was asked for, or that computes without a window.
  std::string other_device{};
};

struct ContextRequest {
  std::string name = "auto";  // auto, window, egl, osmesa
  bool for_view = false;      // auto then takes the window; without it EGL on a GPU, else OSMesa, else EGL on software
  int width = 1280, height = 720;
  std::string title = "fascia";
  bool debug = false;  // KHR_debug output, synchronous
  // Number of an EGL device, with which auto means egl where no window is wanted; -1: the first GPU, of a window that
  // of its display.
  int device = -1;
};

/// auto, egl or osmesa. The context is current and loaded (gl::load). Throws Error with the attempts and the reason of
/// each failure, or with the missing compute support.
std::unique_ptr<Context> make_headless_context(const ContextRequest& request);

// The attempts of make_headless_context; each throws Error on failure.
std::unique_ptr<Context> make_osmesa_context(const ContextRequest& request);
enum class EglDevices { hardware_only, any };  // first the device platform, then surfaceless
std::unique_ptr<Context> make_egl_context(const ContextRequest& request, EglDevices devices);

/// What EGL offers: its devices in their order, and then Mesa's surfaceless platform.
struct EglDevice {
  std::string name;       // "device 0", "surfaceless"
  std::string file;       // "/dev/dri/card0", where known
  bool software = false;  // computed by the CPU
  bool nvidia = false;    // by NVIDIA's own driver
  // Of egl_devices() only:
  std::string renderer;  // with its version; empty where there is no context
  std::string refusal;   // why there is no context
};
/// As EGL describes them, without a context. Throws Error without EGL.
std::vector<EglDevice> list_egl_devices();
/// Makes a context on each for a moment, after which none is current. Throws Error without EGL.
std::vector<EglDevice> egl_devices();
/// Whether the system shows a device that could be a GPU, which takes no time to find out.
bool may_have_gpu();

}  // namespace fascia
