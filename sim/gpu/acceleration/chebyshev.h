// Chebyshev semi-iterative acceleration of the positions (Wang 2015): overshoots the sweep by weights that follow from
// the spectral radius of the iteration. The radius is estimated on the GPU
// (shaders/sim/acceleration/chebyshev_weight.comp) or given in the step's values.
#pragma once
#include <vector>

#include "gl/compute_pass.h"
#include "sim/gpu/passes/sim_buffers.h"

namespace fascia {

class Chebyshev {
 public:
  Chebyshev(const gl::ProgramCache& programs, std::uint32_t vertex_count);

  /// Three passes that run after the method's passes of an iteration. `start`: where the first iteration of the substep
  /// began, vec4 [vertex_count]; `displacement`: the result of the sweep; `step`: the uniform block.
  std::vector<gl::ComputePass> passes(gl::ProgramCache& programs, const gl::Buffer& step, const gl::Buffer& start,
                                      const gl::Buffer& displacement, bool first) const;
  /// Discards the estimate, which is valid only for the materials and the step of its computation.
  void forget_spectral_radius();
  double spectral_radius() const;  // waits for the GPU; 0: not estimated yet

 private:
  std::uint32_t vertex_count_, lanes_, partials_;
  gl::Buffer iterate_, before_;  // vec4 [vertex_count] x_k, x_{k-1}
  gl::Buffer square_partials_;   // vec4 [partials]
  gl::Buffer state_;             // shaders/sim/acceleration/chebyshev_state.glsl
};

}  // namespace fascia
