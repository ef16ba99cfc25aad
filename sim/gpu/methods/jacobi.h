// XPBD with the Green strain of each tet as a 6-vector constraint, all tets at once, corrections averaged per vertex:
// the method of the I3D 2019 paper (Boukadida, Andrews, Paquette 2019). On whole masses its fixed point is softer than
// the material, because averaging gives the multipliers the full step and the positions only a part of it. On split
// masses (predict.comp) both get the same part.
#pragma once
#include "sim/gpu/methods/method.h"

namespace fascia {

class JacobiMethod : public StepMethod {
 public:
  /// `split_masses`: every tet sees its share of a vertex's mass (method "mass_splitting").
  JacobiMethod(const SimBuffers& buffers, bool split_masses);
  const gl::Buffer* copy_begin() const override { return copy_begin_; }
  Deferral most_deferred(const SimBuffers& buffers, bool) const override {
    return {1, buffers.pair_and_single_count()};
  }
  Passes iteration(const Recording& recording, bool first) const override;

 private:
  const gl::Buffer* copy_begin_;
  gl::Buffer multiplier_;  // vec4 [2 * tet_count] lambda, xyz of xx, yy, zz then of yz, xz, xy
};

}  // namespace fascia
