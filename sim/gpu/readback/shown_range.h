// Smallest and largest value of the heat map that is shown, for a color bar that follows it: computed on the GPU, read
// without waiting.
#pragma once
#include <Eigen/Core>
#include <optional>

#include "gl/compute_pass.h"
#include "gl/fence.h"

namespace fascia {

class ShownRange {
 public:
  /// `positions` vec4 [vertex_count or more], of which w is the scalar.
  ShownRange(gl::ProgramCache& programs, const gl::Buffer& positions, std::uint32_t vertex_count);
  /// Queues the range of the current positions; the CPU can take it a frame later.
  void request();
  bool pending() const { return fence_.is_set(); }
  /// The smallest and largest value of the last request, once; with `wait`, waits for the GPU. None while it is not
  /// available or no value is finite.
  std::optional<Eigen::Vector2d> take(bool wait);

 private:
  std::uint32_t partial_count_;
  gl::Buffer partials_, staging_;
  gl::ComputePass pass_;
  gl::Fence fence_;
};

}  // namespace fascia
