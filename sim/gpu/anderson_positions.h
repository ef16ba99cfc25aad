// Anderson acceleration of the positions (Peng, Deng, Zhang, Geng, Qin, Liu 2018, "Anderson acceleration for geometry optimization
// and physics simulation", without its energy test, for which the constraint methods have no energy): the poster's. It sees the
// positions only. The multipliers advance by plain iterations, so the elastic compliance that they carry is lost.
#pragma once
#include <vector>

#include "render/gl/compute_pass.h"
#include "sim/gpu/sim_buffers.h"

namespace fascia {

class AndersonPositions {
 public:
  /// `window`: 1 to kLargestWindow earlier iterations. Memory: 2 * window + 3 vec4 per vertex.
  AndersonPositions(const gl::ProgramCache& programs, std::uint32_t vertex_count, int window);

  /// To run after the method's passes of an iteration: one pass in the first iteration of a substep, four in the others. `start`
  /// is where the first iteration began, vec4 [vertex_count]; `displacement` what the sweep made of it.
  std::vector<gl::ComputePass> passes(gl::ProgramCache& programs, const gl::Buffer& start, const gl::Buffer& displacement,
                                      bool first) const;

 private:
  std::uint32_t vertex_count_, window_, lanes_, partials_;
  gl::Buffer iterate_, residual_, image_;       // vec4 [vertex_count] x_k, f_k, G(x_k)
  gl::Buffer residual_change_, image_change_;   // vec4 [window * vertex_count] columns of dF and dG
  gl::Buffer dot_partials_;                     // vec4 [window * partials]
  gl::Buffer state_;                            // shaders/sim/anderson_state.glsl
};

}  // namespace fascia
