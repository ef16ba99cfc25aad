// What a solver method is to the step: the passes that it records between the prediction and the velocity update.
#pragma once
#include <iterator>
#include <utility>
#include <vector>

#include "render/gl/compute_pass.h"
#include "sim/gpu/active_set.h"
#include "sim/gpu/deferred_tets.h"
#include "sim/gpu/features.h"
#include "sim/gpu/grab_springs.h"
#include "sim/gpu/reduction.h"
#include "sim/gpu/sim_buffers.h"

namespace fascia {

using Passes = std::vector<gl::ComputePass>;

inline void append(Passes& passes, Passes more) { std::move(more.begin(), more.end(), std::back_inserter(passes)); }

/// What passes are recorded from. All of it outlives them.
struct Recording {
  gl::ProgramCache& programs;
  const SimBuffers& buffers;
  const Features& features;
  const gl::Buffer& previous_strain;  // made only with damping
  const GrabSprings& grab;
  DeferredTets* deferred = nullptr;  // null: no material defers tets
  const ActiveSet* active = nullptr;       // what the passes go through; null: everything

  // ComputePass::loops(): of kernels that go through the slots or the tets of a vertex; of those that decompose a tet's or a pair's
  // deformation, if a material wants it, twice at most; of sums over so many items, in each of which there are `inner`.
  std::uint32_t loops_of_slots() const { return buffers.most_slots + 1; }
  std::uint32_t loops_of_vertex() const { return buffers.most_tets + 1; }
  std::uint32_t loops_of_tet() const { return features.signed_st_venant_kirchhoff ? 32 : 0; }
  std::uint32_t loops_of_pair() const { return 2 * loops_of_tet(); }
  static std::uint32_t loops_of_sum(std::uint32_t items, const Reduction& sum, std::uint32_t inner = 0) {
    return (items / sum.lanes + 2) * (1 + inner);
  }

  /// A pass of an invocation per vertex, tet or pair of tets (shaders/common/tet_pair.glsl); over tets it is always all of them.
  gl::ComputePass over_vertices(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings) const;
  gl::ComputePass over_tets(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings) const;
  gl::ComputePass over_pairs(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                             gl::ComputePass::Constants constants = {}) const;
  /// The same and, with materials that have them, one over the pairs that it deferred.
  Passes over_pairs_deferring(const char* kernel, const gl::Defines& defines, const gl::ComputePass::Bindings& bindings) const;
  /// For the pairs that were deferred last.
  gl::ComputePass over_deferred(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings) const;
  /// For each of the ranges, from begin[k] to begin[k + 1], one of an invocation per item, which begins at the kernel's constant
  /// first_item, and one over the items that it deferred.
  /// `loops`: ComputePass::loops() without decompositions, and how many tets an item may decompose.
  Passes over_ranges_deferring(const char* kernel, const gl::Defines& defines, const gl::ComputePass::Bindings& bindings,
                               const std::vector<std::uint32_t>& begin, std::uint32_t loops, std::uint32_t decompositions) const;
  /// A sum over them; the kernel's loop ends at the constant vertex_count or pair_and_single_count.
  gl::ComputePass sum_over_vertices(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings, const Reduction& sum,
                                    gl::ComputePass::Constants constants = {}) const;
  gl::ComputePass sum_over_pairs(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings, const Reduction& sum,
                                 gl::ComputePass::Constants constants = {}) const;

 private:
  std::pair<gl::Defines, gl::ComputePass::Bindings> deferring(gl::Defines defines, gl::ComputePass::Bindings bindings) const;
  gl::ComputePass over_deferred(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings, std::uint32_t list,
                                std::uint32_t most, gl::ComputePass::Constants constants) const;
};

class StepGradient;

class StepMethod {
 public:
  StepMethod() = default;
  virtual ~StepMethod() = default;
  StepMethod(const StepMethod&) = delete;
  StepMethod& operator=(const StepMethod&) = delete;

  /// uint [vertex_count + 1], copies before each vertex, of methods that share a vertex's mass between copies; null for the others.
  virtual const gl::Buffer* copy_begin() const { return nullptr; }
  /// Whether the iterations start where inertia alone leads, x_n + h v_n, and not at the prediction, which gravity has moved too.
  virtual bool starts_without_gravity() const { return false; }
  /// vec4 [2 * tet_count], of methods whose multipliers are part of the state that an acceleration combines; null for the others.
  virtual const gl::Buffer* multiplier() const { return nullptr; }
  /// What is computed before every iteration, of methods that descend the step's objective; null for the others.
  virtual const StepGradient* gradient() const { return nullptr; }
  virtual Passes begin(const Recording&) const { return {}; }  // once a substep, after the prediction
  /// What changes slowly enough to serve for some iterations: before those that refreshes_before() names.
  virtual Passes refresh(const Recording&) const { return {}; }
  /// The first, and every eighth unless so few are left that they would save less than it costs.
  static bool refreshes_before(int iteration, int iterations) {
    constexpr int kInterval = 8, kLeastLeft = 4;
    return iteration == 0 || (iteration % kInterval == 0 && iterations - iteration >= kLeastLeft);
  }
  /// One iteration, the grab's springs included. The first one of a substep finds no history.
  virtual Passes iteration(const Recording& recording, bool first) const = 0;
  virtual Passes end(const Recording&) const { return {}; }  // after the last iteration of a substep, unless a stop rule ended them
  /// What the passes of an iteration may put off (deferred_tets.h). `fused`: whether passes are (render/gl/fused_pass.h).
  virtual Deferral most_deferred(const SimBuffers&, bool fused) const { return static_cast<void>(fused), Deferral{}; }
  /// Before passes are recorded, with what they will be recorded from.
  virtual void prepare(const Recording&) {}
  /// Before the first step of some that go through a part of the tets only.
  virtual void begin_partial() {}
  /// Materials, masses, gravity or h have other values; buffers and passes stay.
  virtual void values_changed(const Model&, const SolverSettings&) {}
  /// What holds the body beside the tissue; targets may be others at every call.
  virtual void set_springs(const std::vector<GrabSpring>&) {}
  /// Whether all is there that the first step needs; what takes long is computed beside what else is made.
  virtual bool ready() const { return true; }
  /// Waits until it is. Before any step, and before the two below tell of later results.
  virtual void complete() {}
  /// Uploads what was computed beside the frame, if it is ready, or, with `wait`, all of it when it is. Returns how many results.
  virtual int update(bool wait) { return static_cast<void>(wait), 0; }
  /// Waits for so many results, if as many are computed, and uploads them.
  virtual void take(int results) { static_cast<void>(results); }
};

}  // namespace fascia
