// Which graphics device draws a window. No call chooses it: drivers read variables of the environment when the window
// is made. What they took is seen only then, and compared with what was wanted.
#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "gl/context/context.h"
#include "gl/loader.h"

namespace fascia {

/// Variables under which a window is drawn by this device: Mesa's DRI_PRIME with the PCI slot, which `sys` (/sys)
/// knows, NVIDIA's render offload, or Mesa's software renderer. Throws Error for other devices.
std::vector<std::pair<std::string, std::string>> window_environment(const EglDevice& device,
                                                                    const std::filesystem::path& sys = "/sys");

/// Sets these variables for EGL device `number`, and returns what a context of that device is. Throws Error if there is
/// no such device, if it has no context, or as window_environment() does. Call before the first window.
gl::Device ask_for_window_device(int number);

bool same_device(const gl::Device& a, const gl::Device& b);

/// A line if the window's device is another one than that of `--device number`, else empty.
std::string other_device_than(int number, const gl::Device& wanted, const gl::Device& window);

/// For a window that draws on `window` without a wish: a line if commands without a window would compute on another
/// device, else empty. Looks only on systems with several GPUs, or with one that the window does not use. Leaves no
/// context current, or the one that was.
std::string other_device_without_window(const gl::Device& window);

}  // namespace fascia
