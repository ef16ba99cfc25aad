// An external energy E(u) of the step's objective, besides inertia and the tets. The springs of grabs are one;
// docs/developers/adding.md adds another. On the GPU its functions are NAME_gradient and NAME_stiffness
// (shaders/sim/energy/terms.glsl).
#pragma once
#include <string>
#include <vector>

#include "gl/compute_pass.h"
#include "sim/coarse/coarse_matrix.h"
#include "sim/gpu/passes/sim_buffers.h"

namespace fascia {

class EnergyTerm {
 public:
  virtual ~EnergyTerm() = default;
  /// The prefix of its functions and, in capitals, of the define that includes them.
  virtual std::string name() const = 0;
  /// Whether the term acts anywhere. While it does not, none of its code is compiled, and nothing is bound, allocated
  /// or dispatched. Passes are recorded again when the result changes.
  virtual bool acts() const = 0;
  /// Adds the buffers that its functions read.
  virtual void bind(gl::ComputePass::Bindings& bindings) const = 0;
  /// The stiffness that the term adds to vertices, for the coarse matrix.
  virtual std::vector<VertexStiffness> stiffness() const = 0;
  /// Passes for methods that do not descend the objective: they project the term as constraints after an iteration.
  virtual std::vector<gl::ComputePass> project(gl::ProgramCache& programs, const SimBuffers& buffers,
                                               bool first) const = 0;
  /// Adds its impulses, h^2 times its forces on the tissue, to those of the tets (SimBuffers::correction), so that
  /// diagnostics include them.
  virtual std::vector<gl::ComputePass> impulses(gl::ProgramCache& programs, const SimBuffers& buffers) const = 0;
};

using EnergyTerms = std::vector<const EnergyTerm*>;

/// Adds the defines of a kernel that includes terms.glsl, and the buffers of the terms that act.
gl::Defines with_energy_terms(gl::Defines defines, gl::ComputePass::Bindings& bindings, const EnergyTerms& terms);
/// The stiffness of all terms that act.
std::vector<VertexStiffness> stiffness_of(const EnergyTerms& terms);

}  // namespace fascia
