// XPBD swept color by color (the poster's section 3.1): each tet sees the corrections of the colors before it. Converges where
// averaged Jacobi stays soft; costs one dispatch per color.
#pragma once
#include <vector>

#include "render/gl/compute_pass.h"
#include "sim/coloring.h"
#include "sim/gpu/features.h"
#include "sim/gpu/sim_buffers.h"

namespace fascia {

class GaussSeidelMethod {
 public:
  explicit GaussSeidelMethod(const Model& model);
  /// The passes of one iteration, one per color. The first one of a substep starts from zero multipliers.
  std::vector<gl::ComputePass> iteration(gl::ProgramCache& programs, const SimBuffers& buffers, const Features& features,
                                         const gl::Buffer& previous_strain, bool first) const;

 private:
  std::vector<std::uint32_t> color_begin_;  // [color_count + 1]
  gl::Buffer color_tet_;                    // uint [tet_count] tets sorted by color
  gl::Buffer multiplier_;                   // vec4 [2 * tet_count] lambda
};

}  // namespace fascia
