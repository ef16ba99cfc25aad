// The kernels that were linked, as the driver got them. For compilers of other devices.
#pragma once
#include <map>
#include <string>
#include <utility>

namespace fascia::test {

/// File below shaders, and the defines that are on: "damping signed_st_venant_kirchhoff".
using KernelName = std::pair<std::string, std::string>;

/// Runs all kernel_cases() in the current context, with storage blocks for reads, and adds the kernel of pictures.
/// Dispatches are left out, so states mean nothing and no driver translates a kernel.
std::map<KernelName, std::string> kernel_texts();

}  // namespace fascia::test
