// Two levels: every vertex's own 3x3 block of the step's Hessian, and a coarse space of a few hundred functions whose
// stiffness rotates with the tissue (coarse_level.h). The coarse space solves the motion of large parts, to which the
// blocks are blind, at once, so the number of iterations hardly depends on the mesh. The two corrections z_f and z_c
// are combined with the last step p by minimizing a quadratic model of the objective over their span, with the
// curvature along the last step taken from the change of the gradient (compare the locally optimal block iteration of
// Knyazev 2001, and the two-dimensional subspace trust region of Byrd, Schnabel, Shultz 1988). Only a part of a step
// that raises the objective is kept. The span of the first iteration has no p: that would be the inertial step, which
// is so long that the change of the gradient along it is not the curvature at its end (errors in motion were 2 to 3
// times larger with it).
#pragma once
#include "sim/gpu/acceleration/anderson.h"
#include "sim/gpu/methods/coarse_level.h"
#include "sim/gpu/passes/reduction.h"
#include "sim/gpu/passes/step_gradient.h"

namespace fascia {

class TwoLevelMethod : public StepMethod {
 public:
  /// `subspace`: z_f and z_c each get their own factor. `nonlinear_cg`: their sum gets one. `none`: the same without p.
  /// `anderson`: their sum gets one, and the direction to Anderson's combination of relaxed sweeps u - 0.4 (z_f + z_c)
  /// another.
  TwoLevelMethod(const gl::ProgramCache& programs, const Model& model, const SimBuffers& buffers,
                 const SolverSettings& settings);

  bool goes_on_with(const MethodInputs& inputs) override;  // the levels stay unchanged
  bool accelerates_itself() const override { return true; }
  bool may_rest_in_regions() const override { return !anderson_; }
  bool starts_without_gravity() const override { return true; }
  const StepGradient* gradient() const override { return &gradient_; }
  void prepare(const Recording& recording) override;
  Passes begin(const Recording& recording) const override;
  Passes before(const Recording& recording, bool first) const override;
  Passes refresh(const Recording& recording) const override;
  Deferral most_deferred(const SimBuffers& buffers, bool) const override {
    return {1u + (buffers.has_linear() && buffers.has_quadratic()),
            buffers.pair_and_single_count() + buffers.quadratic_count};
  }
  Passes iteration(const Recording& recording, bool first) const override;
  void relax(const Model& model, bool relaxes) override {
    relaxes_ = relaxes;
    coarse_.relax(model, relaxes);
  }
  Passes renew(const Recording& recording) const override;
  Passes end(const Recording& recording) const override;
  Passes complete_iteration(const Recording& recording) const override;
  void values_changed(const Model& model, const SolverSettings& settings) override {
    coarse_.values_changed(model, settings);
  }
  void set_stiffness(const std::vector<VertexStiffness>& springs) override { coarse_.set_stiffness(springs); }
  void read_for_contact(gl::Downloads& downloads) override { coarse_.read_for_contact(downloads); }
  void set_contact(const std::vector<PointStiffness>& points) override { coarse_.set_contact(points); }
  void forget_contact() override { coarse_.forget_contact(); }
  bool descends() const override { return true; }
  bool ready() const override { return coarse_.ready(); }
  void complete() override { coarse_.complete(); }
  int update(bool wait) override { return coarse_.update(wait); }
  void take(int results) override { coarse_.take(results); }
  void begin_partial() override { gradient_.clear(); }  // it includes resting vertices for the coarse level

 private:
  void set_acceleration(const gl::ProgramCache& programs, const SimBuffers& buffers, const SolverSettings& settings);
  static bool last_group_ends(const Recording& recording);
  static bool gradient_moves(const Recording& recording);
  std::optional<PendingStep> pending(const Recording& recording) const;
  gl::ComputePass update(const Recording& recording, bool last) const;
  gl::ComputePass multipliers(const Recording& recording, bool renews) const;
  Passes blocks_in_contact(const Recording& recording, bool first) const;
  gl::ComputePass objective_sum(const Recording& recording, bool final) const;
  gl::ComputePass sum_for_step(const Recording& recording, const char* kernel, gl::Defines defines,
                               gl::ComputePass::Bindings bindings) const;
  struct StepSolve {  // what a kernel that includes sim/two_level/subspace_step.glsl needs for it
    gl::Defines defines;
    gl::ComputePass::Bindings bindings;
    gl::ComputePass::Constants constants;
  };
  Passes curvature(const Recording& recording, bool quadratic, gl::Defines defines, gl::ComputePass::Bindings bindings,
                   const StepSolve* solve) const;
  Passes subspace_step(const Recording& recording, bool first, bool last) const;
  std::uint32_t term_partials(const Recording& recording) const;  // of the curvatures of external energies

  bool relaxes_ = false;  // a large K of quadratic tets (sim/quadratic/quadratic_multiplier.comp)
  bool remembers_ = false,
       splits_ = false;  // with p, except in the first iteration; with two directions besides p
  StepGradient gradient_;
  CoarseLevel coarse_;
  gl::Buffer vertex_tets_, vertex_quadratic_, block_inverse_;
  gl::Buffer block_free_, block_pressed_;  // vec4 [2 * vertex_count] the blocks without contact, and what it adds
  Reduction vertices_, pairs_, quadratic_;
  gl::Buffer fine_direction_,
      coarse_direction_;                      // vec4 [vertex_count]; the two directions of the step
  gl::Buffer last_step_, previous_gradient_;  // vec4 [vertex_count]
  gl::Buffer partials_, state_;               // partials_: vec4, three sums over the vertices and one over the tets
  gl::Buffer arrivals_;                       // uint, of shaders/common/last_group.glsl; on GPUs
  gl::Buffer guarded_curvature_;      // vec4 [pairs and single tets], with deferred ones: their terms of the curvature
  gl::Buffer guarded_quadratic_;      // vec4 [quadratic_count] the same
  std::optional<Anderson> anderson_;  // of the sweeps; its results are in fine_direction_
};

}  // namespace fascia
