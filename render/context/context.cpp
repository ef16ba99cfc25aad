#include "render/context/context.h"

#include "base/error.h"

namespace fascia {

std::unique_ptr<Context> make_context(const ContextRequest& request) {
  const std::string& name = request.name;
  if (name != "auto" && name != "window" && name != "egl" && name != "osmesa")
    throw Error("context " + name, "unknown", "expected auto, window, egl or osmesa");
  if (name == "window" || (name == "auto" && request.for_view)) {
    if (request.device >= 0)
      throw Error(
          "--device " + std::to_string(request.device), "does not choose the GPU of a window",
          "expected DRI_PRIME=1 (Mesa), or __NV_PRIME_RENDER_OFFLOAD=1 and __GLX_VENDOR_LIBRARY_NAME=nvidia, in "
          "the environment");
    return make_window_context(request);
  }
  return make_headless_context(request);
}

}  // namespace fascia
