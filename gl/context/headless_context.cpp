#include "gl/context/context.h"

#include <filesystem>
#include <functional>

#include "base/error.h"

namespace fascia {
// Looks for devices of Linux's own drivers, NVIDIA's, and those of virtual machines and phones. To open EGL and look
// takes longer than most runs where there is none.
bool may_have_gpu() {
  namespace fs = std::filesystem;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator("/dev/dri", none))
    if (const std::string name = entry.path().filename(); name.starts_with("renderD") || name.starts_with("card"))
      return true;
  for (const char* device :
       {"/dev/nvidiactl", "/dev/nvidia0", "/dev/dxg", "/dev/mali0", "/dev/kgsl-3d0", "/dev/pvr_sync"})
    if (fs::exists(device, none)) return true;
  return !fs::exists("/dev", none);  // not Linux
}

std::unique_ptr<Context> make_headless_context(const ContextRequest& request) {
  const bool with_device = request.device >= 0;
  if (request.name == "osmesa" && !with_device) return make_osmesa_context(request);
  if (request.name == "egl" || (request.name == "auto" && with_device))
    return make_egl_context(request, EglDevices::any);
  if (request.name == "osmesa")
    throw Error("--device " + std::to_string(request.device), "OSMesa has no devices",
                "expected --context egl or auto");
  if (request.name != "auto") throw Error("context " + request.name, "unknown", "expected auto, egl or osmesa");

  std::string tried, passed_over;
  using Make = std::function<std::unique_ptr<Context>()>;
  const std::pair<const char*, Make> kinds[] = {
      {"EGL on a GPU",
       [&] {
         if (!may_have_gpu()) throw Error("egl", "no device of a GPU in /dev", "expected a hardware renderer");
         try {
           return make_egl_context(request, EglDevices::hardware_only);
         } catch (const Error& error) {
           passed_over = error.what();
           throw;
         }
       }},
      {"OSMesa", [&] { return make_osmesa_context(request); }},
      {"EGL on software", [&] { return make_egl_context(request, EglDevices::any); }},
  };
  for (const auto& [name, make] : kinds) {
    try {
      std::unique_ptr<Context> context = make();
      context->passed_over = passed_over;
      return context;
    } catch (const Error& error) {
      tried += (tried.empty() ? "" : ", ") + std::string(name) + " (" + error.what() + ")";
    }
  }
  throw Error("context auto", "no OpenGL 4.3 context; tried " + tried,
              "expected a GPU driver with EGL, or Mesa's software renderer");
}

}  // namespace fascia
