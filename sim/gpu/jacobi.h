// XPBD with the Green strain of each tet as a 6-vector constraint, all tets at once, corrections averaged per vertex: the
// poster's method (Boukadida, Andrews, Paquette 2019). On whole masses its fixed point is softer than the material: averaging
// gives the multipliers the whole step and the positions only a part of it. On split masses (predict.comp) both get the same.
#pragma once
#include <vector>

#include "render/gl/compute_pass.h"
#include "sim/gpu/features.h"
#include "sim/gpu/sim_buffers.h"

namespace fascia {

class JacobiMethod {
 public:
  explicit JacobiMethod(std::uint32_t tet_count);
  /// The passes of one iteration. The first one of a substep starts from zero multipliers without reading them.
  std::vector<gl::ComputePass> iteration(gl::ProgramCache& programs, const SimBuffers& buffers, const Features& features,
                                         const gl::Buffer& previous_strain, bool first) const;

 private:
  gl::Buffer multiplier_;  // vec4 [2 * tet_count] lambda, xyz of xx, yy, zz then of yz, xz, xy
};

}  // namespace fascia
