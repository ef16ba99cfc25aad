// Records passes for methods, accelerations and energy terms, which share the items and the buffers of a pass.
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

/// The inputs of recorded passes. All of them outlive the passes.
struct Recording {
  gl::ProgramCache& programs;
  const SimBuffers& buffers;
  const Features& features;
  const gl::Buffer& previous_strain;  // exists only with damping
  const EnergyTerms& terms;           // external energies
  DeferredTets* deferred = nullptr;   // null: no material defers tets
  const ActiveSet* active = nullptr;  // the items of the passes; null: all

  // Values for ComputePass::loops(): of kernels that iterate over the slots or the tets of a vertex; of kernels that
  // decompose the deformation of a tet or a pair, at most twice, or of a quadratic tet, at its four points and at most
  // three times, if a material needs that; of sums over so many items with `inner` iterations each.
  static constexpr std::uint32_t kPoints = 32;  // of loops over the points of a quadratic tet
  std::uint32_t loops_of_slots() const { return buffers.most_slots + 1; }
  std::uint32_t loops_of_vertex() const { return buffers.most_tets + 1; }
  std::uint32_t loops_of_tet() const {
    return features.models.contains(MaterialModel::signed_st_venant_kirchhoff) ? 32 : 0;
  }
  std::uint32_t loops_of_pair() const { return 2 * loops_of_tet(); }
  std::uint32_t loops_of_quadratic() const { return 12 * loops_of_tet() + kPoints; }
  static std::uint32_t loops_of_sum(std::uint32_t items, const Reduction& sum, std::uint32_t inner = 0) {
    return (items / sum.lanes + 2) * (1 + inner);
  }

  bool has_blocks() const;        // whether a term acts whose stiffness depends on the direction
  bool evaluates_blocks() const;  // whether evaluations() update them
  /// What external energies compute at the beginning of a stage, along its first step, before every gradient, and at
  /// the end of a stage, which may move bodies as wholes first.
  Passes beginnings() const;
  Passes advances(const gl::Buffer& step) const;
  Passes evaluations(const VertexBlocks* blocks = nullptr) const;
  Passes endings(bool moves_bodies) const;
  /// Projects the external energies that act, after an iteration that does not descend the objective.
  Passes projections(bool first) const;

  /// A pass with one invocation per vertex, tet or pair of tets (shaders/common/tet_pair.glsl); a pass over tets always
  /// covers all of them.
  gl::ComputePass over_vertices(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                                gl::ComputePass::Constants constants = {}) const;
  gl::ComputePass over_tets(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings) const;
  gl::ComputePass over_pairs(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                             gl::ComputePass::Constants constants = {}) const;
  /// The same and, if a material defers pairs, a pass over those that it deferred.
  Passes over_pairs_deferring(const char* kernel, const gl::Defines& defines,
                              const gl::ComputePass::Bindings& bindings) const;
  /// The same of quadratic tets.
  gl::ComputePass over_quadratic(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                                 gl::ComputePass::Constants constants = {}) const;
  Passes over_quadratic_deferring(const char* kernel, const gl::Defines& defines,
                                  const gl::ComputePass::Bindings& bindings) const;
  /// A pass over the pairs, or the quadratic tets, that were deferred last.
  gl::ComputePass over_deferred(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings) const;
  gl::ComputePass over_deferred_quadratic(const char* kernel, gl::Defines defines,
                                          gl::ComputePass::Bindings bindings) const;
  /// For each of the ranges, begin[k] to begin[k + 1]: one pass with an invocation per item, which begins at the
  /// kernel's constant first_item, and one over the items that it deferred. `loops`: ComputePass::loops() without
  /// decompositions, and the number of tets that an item may decompose.
  Passes over_ranges_deferring(const char* kernel, const gl::Defines& defines,
                               const gl::ComputePass::Bindings& bindings, const std::vector<std::uint32_t>& begin,
                               std::uint32_t loops, std::uint32_t decompositions) const;
  /// A sum over vertices, pairs or quadratic tets; the kernel's loop ends at the constant vertex_count,
  /// pair_and_single_count or quadratic_count.
  gl::ComputePass sum_over_vertices(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                                    const Reduction& sum, gl::ComputePass::Constants constants = {}) const;
  gl::ComputePass sum_over_pairs(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                                 const Reduction& sum, gl::ComputePass::Constants constants = {}) const;
  gl::ComputePass sum_over_quadratic(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                                     const Reduction& sum, gl::ComputePass::Constants constants = {}) const;

 private:
  std::pair<gl::Defines, gl::ComputePass::Bindings> deferring(gl::Defines defines,
                                                              gl::ComputePass::Bindings bindings) const;
  gl::ComputePass::Constants list_of_quadratic() const;
  gl::ComputePass over_deferred(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                                std::uint32_t list, std::uint32_t most, gl::ComputePass::Constants constants) const;
};

}  // namespace fascia
