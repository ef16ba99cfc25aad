// The objective of an implicit Euler step and its gradient at the displacements, 1/2 (u - u~)^T M (u - u~) + h^2 U(u),
// springs of the grab included: what the methods that descend it start every iteration with.
#pragma once
#include "sim/gpu/passes/recording.h"

namespace fascia {

class StepGradient {
 public:
  explicit StepGradient(const SimBuffers& buffers);
  /// Forces of the tets into the slots, and their sums.
  Passes passes(const Recording& recording) const;
  void clear() { gradient_.clear(); }
  const gl::Buffer& gradient() const { return gradient_; }  // vec4 [vertex_count] xyz g [kg m], w objective [kg m^2]

 private:
  gl::Buffer gradient_;
};

/// Tets around every vertex for kernels that include vertex_block.glsl: uint [4 * tet_count], 4 * tet + corner, those
/// of a vertex from its place in tet_begin on, as the tets are ordered now.
gl::Buffer make_vertex_tets(const SimBuffers& buffers);

}  // namespace fascia
