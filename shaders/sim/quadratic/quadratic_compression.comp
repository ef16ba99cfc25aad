// The largest 1 - J of all quadratic tets, as sim/readback/compression.comp computes it for linear ones, at the points: the
// law acts there alone, so that corners may stay inside out under a load.
#include "common/io.glsl"
#include "common/quadratic_tet.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]
INOUT(uint, Compression, compression)   // [1] that of linear tets
uniform uint quadratic_count;

void main() {
  ITEM_OR_RETURN(i)
  float most = 0.0;
  FOR_ITEMS_OF_LANE(e, i, invocations, quadratic_count) {
    Tet tet = load_tet(FIRST_QUADRATIC + e);
    PointGradients h = POINT_GRADIENTS(e, tet, displacement);
    for (int q = 0; q < 4; ++q) most = max(most, -det_f_minus_one(PICK(h, q)));
  }
  // A tet at rest may have -0.0, whose bits are the largest.
  if (most > 0.0) atomicMax(compression[0], floatBitsToUint(most));
}
