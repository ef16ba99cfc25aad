#include "gl/context/context.h"

#include <functional>

#include "base/error.h"

namespace fascia {

std::unique_ptr<Context> make_headless_context(const ContextRequest& request) {
  if (request.name == "osmesa") return make_osmesa_context(request);
  if (request.name == "egl") return make_egl_context(request, EglDevices::any);
  if (request.name != "auto") throw Error("context " + request.name, "unknown", "expected auto, egl or osmesa");

  std::string tried;
  using Make = std::function<std::unique_ptr<Context>()>;
  const std::pair<const char*, Make> kinds[] = {
      {"EGL on a GPU", [&] { return make_egl_context(request, EglDevices::hardware_only); }},
      {"OSMesa", [&] { return make_osmesa_context(request); }},
      {"EGL on software", [&] { return make_egl_context(request, EglDevices::any); }},
  };
  for (const auto& [name, make] : kinds) {
    try {
      return make();
    } catch (const Error& error) {
      tried += (tried.empty() ? "" : ", ") + std::string(name) + " (" + error.what() + ")";
    }
  }
  throw Error("context auto", "no OpenGL 4.3 context; tried " + tried,
              "expected a GPU driver with EGL, or Mesa's software renderer");
}

}  // namespace fascia
