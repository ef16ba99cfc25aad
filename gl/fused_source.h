// One compute program made of several kernels that run one after another (fused_pass.h). No OpenGL here.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "gl/shader_source.h"

namespace fascia::gl {

/// A kernel and what its names mean in the fused program.
struct FusedKernel {
  std::string file;
  Defines defines;
  std::map<std::string, std::string> buffers;  // its name for a buffer, the fused program's
  std::vector<std::string> constants;          // uint uniforms, in the order of their values in the plan
  std::string groups;  // the buffer that has the number of work groups; empty where the plan has it
  bool operator==(const FusedKernel&) const = default;
};

/// Kernels, by their index, that take turns; how many turns is in the plan.
using FusedLoop = std::vector<std::size_t>;

/// The plan, uint: the number of kernels that run in a repeat, the turns of every loop, and a record for every kernel
/// that runs: work groups, or their place in FusedKernel::groups, how many of them may be taken at once, how many loops
/// an invocation of one goes through at most, and the constants.
inline std::uint32_t record_size(const FusedKernel& kernel) {
  return 3 + static_cast<std::uint32_t>(kernel.constants.size());
}

/// `declarations` [lines] of all buffers; `step`: whether kernels know the substep's uniform block. Throws Error as
/// read_shader() does.
ShaderText read_fused(const std::filesystem::path& folder, const Defines& defines,
                      const std::vector<std::string>& declarations, bool step, const std::vector<FusedKernel>& kernels,
                      const std::vector<FusedLoop>& loops);

}  // namespace fascia::gl
