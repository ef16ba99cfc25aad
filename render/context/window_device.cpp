#include "render/context/window_device.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "base/error.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

std::string name_behind(const fs::path& link) {
  std::error_code none;
  return fs::canonical(link, none).filename().string();
}

}  // namespace

std::vector<std::pair<std::string, std::string>> window_environment(const EglDevice& device, const fs::path& sys) {
  // GLX takes the driver of the display unless a library is named; where there is no libglvnd, nothing reads that name.
  const std::string library = "__GLX_VENDOR_LIBRARY_NAME";
  if (device.software) return {{"LIBGL_ALWAYS_SOFTWARE", "1"}, {library, "mesa"}};
  const fs::path hardware = sys / "class/drm" / fs::path(device.file).filename() / "device";
  if (device.nvidia || (!device.file.empty() && name_behind(hardware / "driver") == "nvidia"))
    return {{"__NV_PRIME_RENDER_OFFLOAD", "1"}, {library, "nvidia"}};
  const std::string slot = device.file.empty() ? "" : name_behind(hardware);
  unsigned domain = 0, bus = 0, place = 0, function = 0;
  char end = 0;
  if (std::sscanf(slot.c_str(), "%x:%x:%x.%x%c", &domain, &bus, &place, &function, &end) != 4)
    throw Error(device.name, "not a PCI device that drivers of windows find by its slot",
                "expected DRI_PRIME=1 in the environment instead, for the second GPU of Mesa");
  char tag[64];
  std::snprintf(tag, sizeof tag, "pci-%04x_%02x_%02x_%1x", domain, bus, place, function);
  return {{"DRI_PRIME", tag}, {library, "mesa"}};
}

gl::Device ask_for_window_device(int number) {
  gl::Device wanted;
  {
    const auto context = make_egl_context({.device = number}, EglDevices::any);
    wanted = gl::device();
  }
  for (const EglDevice& device : list_egl_devices())
    if (device.name == "device " + std::to_string(number))
      for (const auto& [name, value] : window_environment(device)) setenv(name.c_str(), value.c_str(), 1);
  return wanted;
}

bool same_device(const gl::Device& a, const gl::Device& b) {
  return a.renderer == b.renderer && (a.uuid.empty() || b.uuid.empty() || a.uuid == b.uuid);
}

std::string other_device_than(int number, const gl::Device& wanted, const gl::Device& window) {
  if (same_device(wanted, window)) return "";
  return "--device " + std::to_string(number) + " is " + wanted.renderer +
         ", but this display has its windows drawn by " +
         (wanted.renderer == window.renderer ? "another one of these" : window.renderer);
}

std::string other_device_without_window(const gl::Device& window) {
  if (!may_have_gpu()) return "";
  try {
    const std::vector<EglDevice> found = list_egl_devices();
    const auto gpus = std::count_if(found.begin(), found.end(), [](const EglDevice& device) {
      return device.name != "surfaceless" && !device.software;
    });
    if (gpus < (window.software ? 1 : 2)) return "";
    const auto context = make_egl_context({}, EglDevices::hardware_only);
    if (same_device(window, gl::device())) return "";
    return "windows of this display are drawn by " + window.renderer + ", but commands without a window compute on " +
           gl::device().renderer + ": --device N chooses for both, of those that fascia info --device lists";
  } catch (const Error&) {  // no EGL, or no context of a GPU
    return "";
  }
}

}  // namespace fascia
