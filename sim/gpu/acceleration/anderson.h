// Anderson acceleration, type II (Anderson 1965; Walker and Ni 2011), of a method's sweep z -> G(z): the next z
// combines the last images so that the combined residual f = G(z) - z is smallest. On the displacements alone it is the
// variant of the I3D 2019 paper (Peng, Deng, Zhang, Geng, Qin, Liu 2018): with XPBD methods the multipliers then
// advance by plain iterations, and the elastic compliance that they carry is lost. With the multipliers as a second
// part, under the same weights and an inner product in which both are comparable, the fixed point of the method is
// unchanged.
#pragma once
#include <vector>

#include "sim/gpu/passes/recording.h"

namespace fascia {

/// A piece of the state z: vectors in the xyz of `value`, w is not changed.
struct AndersonPart {
  const gl::Buffer* value;  // vec4 [count]
  std::uint32_t count;
  const gl::Buffer* weight;  // float [count] of the inner product sum_i w_i |f_i|^2; null: all 1
};

class Anderson {
 public:
  /// `window`: 1 to kLargestWindow earlier iterations. Memory: 2 * window + 3 vec4 per vector of the state.
  Anderson(const gl::ProgramCache& programs, std::vector<AndersonPart> parts, int window);

  /// Passes before the first sweep of a substep: one per part, which stores z_0.
  Passes begin(gl::ProgramCache& programs) const;
  /// Passes after every sweep: one per part in the first iteration, three per part and one more in the others.
  Passes passes(gl::ProgramCache& programs, bool first) const;
  /// vec4 [count]: the start z_k of that part's sweep. The acceleration stores it from the previous iteration; code
  /// that changes the state in between writes it before every sweep.
  const gl::Buffer& iterate(std::size_t part) const { return histories_[part].iterate; }

 private:
  struct History {
    gl::Buffer iterate, residual, image;       // vec4 [count] z_k, f_k (w: weight), G(z_k)
    gl::Buffer residual_change, image_change;  // vec4 [window * count] columns of dF and dG
  };
  std::vector<AndersonPart> parts_;
  std::vector<History> histories_;
  std::uint32_t window_, lanes_, partials_;
  gl::Buffer dot_partials_;  // vec4 [parts * window * partials]
  gl::Buffer state_;         // shaders/sim/acceleration/anderson_state.glsl
};

}  // namespace fascia
