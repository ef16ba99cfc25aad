// XPBD with an exact fixed point. XPBD neglects the residual of the positions, g = M (x - x~) - G^T lambda, which is
// zero only in the limit of small steps; Jacobi sweeps never remove it. This method feeds g back with every sweep and
// raises each vertex's mass by the tension around it, so that the sweep stays a contraction. Then g vanishes at the
// fixed point, which is the implicit Euler step:
//
//   g_i = m_i (x_i - x~_i) - sum_e G_i^T lambda_e,     m^_i = m_i + 2 sum_e |b_i|^2 |mat(lambda_e)|
//   [ sum_a (n_a / m^_a) G_a G_a^T + alpha~ ] dlambda = -C - alpha~ lambda + sum_a G_a g_a / m^_a
//   x_i += (sum_e G_i^T dlambda_e - g_i) / m^_i
#pragma once
#include "sim/gpu/methods/method.h"

namespace fascia {

class ExactXpbdMethod : public StepMethod {
 public:
  explicit ExactXpbdMethod(const SimBuffers& buffers);
  const gl::Buffer* multiplier() const override { return &multiplier_; }
  const gl::Buffer& weight_of_vertices(const SimBuffers&) const override { return raised_mass_; }
  /// The multipliers start in equilibrium with the stress at the prediction: accelerated iterations stall from zero.
  Passes begin(const Recording& recording) const override;
  Deferral most_deferred(const SimBuffers& buffers, bool) const override {
    return {1, buffers.pair_and_single_count()};
  }
  bool descends() const override { return true; }
  Passes iteration(const Recording& recording, bool first) const override;

 private:
  gl::Buffer multiplier_;   // vec4 [2 * tet_count] lambda
  gl::Buffer primal_step_;  // vec4 [vertex_count] g / m^ [m]
  gl::Buffer raised_mass_;  // float [vertex_count] m^ [kg]
};

}  // namespace fascia
