// Recorded passes that run one after another in as few dispatches as can be. A dispatch costs some microseconds, and
// where threads are to be woken for it some ten, more than the work of a small mesh; in one dispatch the work groups
// wait for each other instead (shaders/common/fused.glsl). On llvmpipe only: what a kernel wrote is read through buffer
// textures by those after it, within one dispatch, and a work group is taken for one vector. llvmpipe reads memory and
// computes in step; OpenGL promises neither.
#pragma once
#include <memory>
#include <vector>

#include "gl/compute_pass.h"

namespace fascia::gl {

/// Whether passes can be fused here, and are to be.
bool fuses(const ProgramCache& programs);

class FusedPasses {
 public:
  FusedPasses() = default;
  /// Passes that do not tell their loops, and those that have no other to go with, are dispatched by themselves. Counts
  /// on what they copy first (ComputePass::copy_first) to stay as it is. What the passes refer to must outlive it.
  /// Throws Error.
  FusedPasses(ProgramCache& programs, const std::vector<ComputePass>& passes);

  /// All of them, so many times. Waits for the device after every fused dispatch, to know whether it came to its end:
  /// on llvmpipe that is the processor itself. Throws Error.
  void run(std::uint32_t repeats = 1) const;
  /// Of `repeats` runs, unless the work is too much for a dispatch (fused.glsl).
  std::uint64_t dispatches(std::uint32_t repeats) const;

 private:
  class Dispatch;
  std::vector<std::shared_ptr<const Dispatch>> dispatches_;
};

}  // namespace fascia::gl
