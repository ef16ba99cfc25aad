// Runs recorded passes in sequence with as few dispatches as possible. A dispatch costs some microseconds, or some tens
// if threads must be woken, which exceeds the work of a small mesh; in one dispatch the work groups wait for each other
// instead (shaders/common/fused.glsl). Only for llvmpipe: later kernels read earlier results through buffer textures
// within one dispatch, and a work group is assumed to be one vector. llvmpipe accesses memory in order and computes in
// lockstep; OpenGL guarantees neither.
#pragma once
#include <memory>
#include <vector>

#include "gl/compute_pass.h"

namespace fascia::gl {

/// Whether passes can be fused here, and fusing is enabled.
bool fuses(const ProgramCache& programs);

class FusedPasses {
 public:
  FusedPasses() = default;
  /// Passes that do not state their loops, and those without a neighbor to fuse with, are dispatched separately. The
  /// sources of ComputePass::copy_first must not change. All objects that the passes use must outlive this one. Throws
  /// Error.
  FusedPasses(ProgramCache& programs, const std::vector<ComputePass>& passes);

  /// Runs all passes `repeats` times. Waits for the device after every fused dispatch to check that it was completed:
  /// on llvmpipe the device is the CPU itself. Throws Error.
  void run(std::uint32_t repeats = 1) const;
  /// The dispatches of `repeats` runs, unless the work exceeds one dispatch (fused.glsl).
  std::uint64_t dispatches(std::uint32_t repeats) const;

 private:
  class Dispatch;
  std::vector<std::shared_ptr<const Dispatch>> dispatches_;
};

}  // namespace fascia::gl
