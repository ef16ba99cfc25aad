// The height of the lowest point of the drawn surface, for a ground that stays below it: computed on the GPU, read
// without waiting.
#pragma once
#include <optional>
#include <vector>

#include "gl/compute_pass.h"
#include "gl/fence.h"

namespace fascia {

class LowestPoint {
 public:
  /// `positions`: vec4 (SurfacePositions); `vertices`: those that are drawn, at least one.
  LowestPoint(gl::ProgramCache& programs, const gl::Buffer& positions, const std::vector<std::uint32_t>& vertices);
  /// Queues the measurement of the current positions; the CPU can take it a frame later.
  void request();
  bool pending() const { return fence_.is_set(); }
  /// The smallest y [m] of the last request, once; with `wait`, waits for the GPU. None while it is not available or no
  /// position is finite.
  std::optional<double> take(bool wait);

 private:
  std::uint32_t partial_count_;
  gl::Buffer vertices_, partials_, staging_;
  gl::ComputePass pass_;
  gl::Fence fence_;
};

}  // namespace fascia
