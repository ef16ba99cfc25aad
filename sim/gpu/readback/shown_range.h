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
  /// Over the positions of now, which the CPU may ask for a frame later.
  void request();
  bool pending() const { return fence_.is_set(); }
  /// Of the last request, once: smallest and largest; with `wait`, waits for the GPU. Nothing while it is not there or
  /// no value is finite.
  std::optional<Eigen::Vector2d> take(bool wait);

 private:
  std::uint32_t partial_count_;
  gl::Buffer partials_, staging_;
  gl::ComputePass pass_;
  gl::Fence fence_;
};

}  // namespace fascia
