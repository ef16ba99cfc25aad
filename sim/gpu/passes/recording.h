// How passes are recorded: what a pass goes through and the buffers that it reads, the same for methods, accelerations
// and energy terms.
#pragma once
#include <iterator>
#include <utility>
#include <vector>

#include "gl/compute_pass.h"
#include "sim/gpu/passes/active_set.h"
#include "sim/gpu/passes/deferred_tets.h"
#include "sim/gpu/passes/energy_term.h"
#include "sim/gpu/passes/features.h"
#include "sim/gpu/passes/reduction.h"
#include "sim/gpu/passes/sim_buffers.h"

namespace fascia {

using Passes = std::vector<gl::ComputePass>;

inline void append(Passes& passes, Passes more) { std::move(more.begin(), more.end(), std::back_inserter(passes)); }

/// What passes are recorded from. All of it outlives them.
struct Recording {
  gl::ProgramCache& programs;
  const SimBuffers& buffers;
  const Features& features;
  const gl::Buffer& previous_strain;  // made only with damping
  const EnergyTerms& terms;           // external energies
  DeferredTets* deferred = nullptr;   // null: no material defers tets
  const ActiveSet* active = nullptr;  // what the passes go through; null: everything

  // ComputePass::loops(): of kernels that go through the slots or the tets of a vertex; of those that decompose a tet's
  // or a pair's deformation, if a material wants it, twice at most; of sums over so many items, in each of which there
  // are `inner`.
  std::uint32_t loops_of_slots() const { return buffers.most_slots + 1; }
  std::uint32_t loops_of_vertex() const { return buffers.most_tets + 1; }
  std::uint32_t loops_of_tet() const {
    return features.models.contains(MaterialModel::signed_st_venant_kirchhoff) ? 32 : 0;
  }
  std::uint32_t loops_of_pair() const { return 2 * loops_of_tet(); }
  static std::uint32_t loops_of_sum(std::uint32_t items, const Reduction& sum, std::uint32_t inner = 0) {
    return (items / sum.lanes + 2) * (1 + inner);
  }

  /// Of the external energies that act, after an iteration that does not descend the objective.
  Passes projections(bool first) const;

  /// A pass of an invocation per vertex, tet or pair of tets (shaders/common/tet_pair.glsl); over tets it is always all
  /// of them.
  gl::ComputePass over_vertices(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings) const;
  gl::ComputePass over_tets(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings) const;
  gl::ComputePass over_pairs(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                             gl::ComputePass::Constants constants = {}) const;
  /// The same and, with materials that have them, one over the pairs that it deferred.
  Passes over_pairs_deferring(const char* kernel, const gl::Defines& defines,
                              const gl::ComputePass::Bindings& bindings) const;
  /// For the pairs that were deferred last.
  gl::ComputePass over_deferred(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings) const;
  /// For each of the ranges, from begin[k] to begin[k + 1], one of an invocation per item, which begins at the kernel's
  /// constant first_item, and one over the items that it deferred. `loops`: ComputePass::loops() without
  /// decompositions, and how many tets an item may decompose.
  Passes over_ranges_deferring(const char* kernel, const gl::Defines& defines,
                               const gl::ComputePass::Bindings& bindings, const std::vector<std::uint32_t>& begin,
                               std::uint32_t loops, std::uint32_t decompositions) const;
  /// A sum over them; the kernel's loop ends at the constant vertex_count or pair_and_single_count.
  gl::ComputePass sum_over_vertices(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                                    const Reduction& sum, gl::ComputePass::Constants constants = {}) const;
  gl::ComputePass sum_over_pairs(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                                 const Reduction& sum, gl::ComputePass::Constants constants = {}) const;

 private:
  std::pair<gl::Defines, gl::ComputePass::Bindings> deferring(gl::Defines defines,
                                                              gl::ComputePass::Bindings bindings) const;
  gl::ComputePass over_deferred(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                                std::uint32_t list, std::uint32_t most, gl::ComputePass::Constants constants) const;
};

}  // namespace fascia
