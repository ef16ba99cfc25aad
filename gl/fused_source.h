// Generates one compute program from several kernels that run in sequence (fused_pass.h). Independent of OpenGL.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "gl/shader_source.h"

namespace fascia::gl {

/// A kernel and the mapping of its names to the fused program.
struct FusedKernel {
  std::string file;
  Defines defines;
  std::map<std::string, std::string> buffers;  // the kernel's name of a buffer, the fused program's
  std::vector<std::string> constants;          // uint uniforms, in the order of their values in the plan
  std::string groups;                          // the buffer with the number of work groups; empty: the plan has it
  bool operator==(const FusedKernel&) const = default;
};

/// Indices of kernels that run in turn; the number of turns is in the plan.
using FusedLoop = std::vector<std::size_t>;

/// The plan, uint: the number of kernels per repeat, the turns of every loop, and a record for every kernel run: work
/// groups, or their index in FusedKernel::groups, the number of groups that may be taken at once, the largest number of
/// loop iterations of an invocation, and the constants.
inline std::uint32_t record_size(const FusedKernel& kernel) {
  return 3 + static_cast<std::uint32_t>(kernel.constants.size());
}

/// `declarations` [lines] of all buffers; `step`: whether the uniform block of the substep is included. Throws Error as
/// read_shader() does.
ShaderText read_fused(const std::filesystem::path& folder, const Defines& defines,
                      const std::vector<std::string>& declarations, bool step, const std::vector<FusedKernel>& kernels,
                      const std::vector<FusedLoop>& loops);

}  // namespace fascia::gl
