#include "render/context/context.h"

#include "base/error.h"

namespace fascia {

std::unique_ptr<Context> make_context(const ContextRequest& request) {
  const std::string& name = request.name;
  if (name != "auto" && name != "window" && name != "egl" && name != "osmesa")
    throw Error("context " + name, "unknown", "expected auto, window, egl or osmesa");
  if (name == "window" || (name == "auto" && request.for_view)) return make_window_context(request);
  return make_headless_context(request);
}

}  // namespace fascia
