// An external energy E(u) of the step's objective, besides inertia and the tets. The springs of grabs are one, contact
// is another; docs/developers/adding.md adds one more. On the GPU its functions are in shaders/sim/energy/terms.glsl.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "gl/compute_pass.h"
#include "sim/coarse/coarse_matrix.h"
#include "sim/gpu/passes/sim_buffers.h"

namespace fascia {

struct Recording;  // sim/gpu/passes/recording.h

/// What a kernel that includes terms.glsl takes from the terms.
enum class TermUse {
  gradient,   // NAME_gradient
  stiffness,  // NAME_stiffness, for sums over the vertices
  block,      // NAME_stiffness and NAME_block_of
  all         // NAME_gradient and NAME_stiffness: sweeps over the vertices
};

/// Where and how a method that descends the objective adds curvatures along its directions.
struct TermCurvature {
  const gl::Buffer &fine_direction, *coarse_direction;  // vec4 [vertex_count]; null: one direction
  const gl::Buffer& last_step;                          // vec4 [vertex_count] p
  const gl::Buffer& partials;                           // vec4
  std::uint32_t first_partial;
};

/// Rows that press on one side only, along the directions of TermCurvature (shaders/sim/two_level/pressing_step.glsl).
struct PressingRows {
  const gl::Buffer &along, &list;
  std::uint32_t loops;  // of an invocation that looks at them, at most
};

/// Where a method keeps its vertices' blocks of the Hessian: without the terms that have blocks, and their inverses
/// with them.
struct VertexBlocks {
  const gl::Buffer &free, &inverse;  // vec4 [2 * vertex_count]: shaders/sim/two_level/block_inverse.comp
};

class EnergyTerm {
 public:
  virtual ~EnergyTerm() = default;
  /// The prefix of its functions and, in capitals, of the define that includes them.
  virtual std::string name() const = 0;
  /// Whether the term acts anywhere. While it does not, none of its code is compiled, and nothing is bound, allocated
  /// or dispatched. Passes are recorded again when the result changes.
  virtual bool acts() const = 0;
  /// Whether its stiffness depends on the direction: it then has blocks and passes of its own instead of a factor.
  virtual bool has_blocks() const { return false; }
  /// The value of its define for a use; none: that use needs nothing from this term.
  virtual std::optional<std::string> define(TermUse) const { return "1"; }
  /// Adds the buffers that its functions read.
  virtual void bind(TermUse use, gl::ComputePass::Bindings& bindings) const = 0;
  /// The stiffness that the term adds to vertices, for the coarse matrix.
  virtual std::vector<VertexStiffness> stiffness() const = 0;
  /// Passes for methods that do not descend the objective: they project the term as constraints after an iteration.
  virtual std::vector<gl::ComputePass> project(gl::ProgramCache& programs, const SimBuffers& buffers,
                                               bool first) const = 0;
  /// Adds its impulses, h^2 times its forces on the tissue, to those of the tets (SimBuffers::correction), so that
  /// diagnostics include them.
  virtual std::vector<gl::ComputePass> impulses(gl::ProgramCache& programs, const SimBuffers& buffers) const = 0;

  // Passes of terms whose forces are not functions of one vertex alone.
  using Passes = std::vector<gl::ComputePass>;
  virtual Passes begin(gl::ProgramCache&, const SimBuffers&) const { return {}; }  // of a stage, after the prediction
  /// From the start of the stage along `step` (vec4 [vertex_count] [m], what is left of it) to where the term first
  /// resists: the iterations go back there if the whole step raises the objective.
  virtual Passes advance(const Recording&, const gl::Buffer& /*step*/) const { return {}; }
  /// Before every gradient. `blocks`: also updates those of the vertices on which the term acts, if it
  /// evaluates_blocks(); or null.
  virtual Passes evaluate(gl::ProgramCache&, const SimBuffers&, const VertexBlocks* /*blocks*/) const { return {}; }
  virtual bool evaluates_blocks() const { return false; }
  /// At the end of a stage, after which bodies may have been moved as wholes.
  virtual Passes finish(gl::ProgramCache&, const SimBuffers&, [[maybe_unused]] bool moves_bodies) const { return {}; }
  virtual Passes curvature(gl::ProgramCache&, const SimBuffers&, const TermCurvature&) const { return {}; }
  virtual std::uint32_t curvature_partials(const gl::ProgramCache&) const { return 0; }
  virtual std::optional<PressingRows> pressing() const { return {}; }  // of a term with blocks, after curvature()
  /// Of a term with blocks: a pass over the vertices on which it acts in a stage.
  virtual Passes over_touched(gl::ProgramCache&, const char* /*kernel*/, gl::Defines, gl::ComputePass::Bindings) const {
    return {};
  }
};

using EnergyTerms = std::vector<const EnergyTerm*>;

/// Adds the defines of a kernel that includes terms.glsl, and the buffers of the terms that act.
gl::Defines with_energy_terms(gl::Defines defines, gl::ComputePass::Bindings& bindings, const EnergyTerms& terms,
                              TermUse use);
/// The stiffness of all terms that act.
std::vector<VertexStiffness> stiffness_of(const EnergyTerms& terms);

}  // namespace fascia
