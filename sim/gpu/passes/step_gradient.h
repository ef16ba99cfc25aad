// The objective of an implicit Euler step and its gradient at the displacements, 1/2 (u - u~)^T M (u - u~) + h^2 U(u),
// including the springs of grabs. Methods that descend the objective start every iteration with it.
#pragma once
#include "sim/gpu/passes/recording.h"

namespace fascia {

class StepGradient {
 public:
  explicit StepGradient(const SimBuffers& buffers);
  /// Writes the forces of the tets to the slots and sums them.
  Passes passes(const Recording& recording) const;
  void clear() { gradient_.clear(); }
  const gl::Buffer& gradient() const { return gradient_; }  // vec4 [vertex_count] xyz g [kg m], w objective [kg m^2]

 private:
  gl::Buffer gradient_;
};

/// The linear tets around every vertex for kernels that include sim/elasticity/vertex_block.glsl: uint
/// [4 * linear_count], 4 * tet + corner, those of a vertex from its offset in tet_begin, in the current order of the
/// tets.
gl::Buffer make_vertex_tets(const SimBuffers& buffers);
/// The quadratic tets for sim/quadratic/vertex_block.glsl: uint [10 * quadratic_count], 10 * tet + node, by
/// quadratic_begin.
gl::Buffer make_vertex_quadratic(const SimBuffers& buffers);

}  // namespace fascia
