// The objective of an implicit Euler step and its gradient at the displacements, 1/2 (u - u~)^T M (u - u~) + h^2 U(u),
// including the springs of grabs. Methods that descend the objective start every iteration with it.
#pragma once
#include <optional>

#include "sim/gpu/passes/force_clusters.h"
#include "sim/gpu/passes/recording.h"

namespace fascia {

/// A step that has been solved but not applied: the gradient after it applies it
/// (shaders/sim/two_level/subspace_move.glsl).
struct PendingStep {
  gl::Defines defines;
  gl::ComputePass::Bindings step;       // of all kernels of the gradient
  const gl::Buffer& previous_gradient;  // vec4 [vertex_count] takes the gradient before a step that is kept
};

class StepGradient {
 public:
  StepGradient(const gl::ProgramCache& programs, const SimBuffers& buffers);
  /// Writes the forces of the tets to the slots and sums them. `pending`: after that step. `evaluated`: external
  /// energies are, where the displacements are now. `blocks`: of EnergyTerm::evaluate().
  Passes passes(const Recording& recording, const std::optional<PendingStep>& pending = {}, bool evaluated = false,
                const VertexBlocks* blocks = nullptr) const;
  void clear() { gradient_.clear(); }
  const gl::Buffer& gradient() const { return gradient_; }  // vec4 [vertex_count] xyz g [kg m], w objective [kg m^2]

 private:
  gl::ComputePass clustered(const Recording& recording, gl::Defines defines, gl::ComputePass::Bindings bindings) const;

  gl::Buffer gradient_;
  std::optional<ForceClusters> clusters_;
};

/// The linear tets around every vertex for kernels that include sim/elasticity/vertex_block.glsl: uint
/// [4 * linear_count], 4 * tet + corner, those of a vertex from its offset in tet_begin, in the current order of the
/// tets.
gl::Buffer make_vertex_tets(const SimBuffers& buffers);
/// The quadratic tets for sim/quadratic/vertex_block.glsl: uint [10 * quadratic_count], 10 * tet + node, by
/// quadratic_begin.
gl::Buffer make_vertex_quadratic(const SimBuffers& buffers);

}  // namespace fascia
