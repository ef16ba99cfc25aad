// The largest 1 - J of all linear tets, as bits of a float, whose order is that of floats that are not
// negative: for the CPU, which looks whether tissue may be tangled (sim/gpu/readback/tangle_watch.h).
#include "common/io.glsl"
#include "common/tet.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]
INOUT(uint, Compression, compression)   // [1] initially zero
uniform uint tet_count;

void main() {
  ITEM_OR_RETURN(i)
  float most = 0.0;
  FOR_ITEMS_OF_LANE(t, i, invocations, tet_count) {
    Tet tet = load_tet(t);
    mat3 h = displacement_gradient(tet, FETCH(displacement, tet.v.x).xyz, FETCH(displacement, tet.v.y).xyz,
                                   FETCH(displacement, tet.v.z).xyz, FETCH(displacement, tet.v.w).xyz);
    most = max(most, -det_f_minus_one(h));
  }
  // A tet at rest may have -0.0, whose bits are the largest.
  if (most > 0.0) atomicMax(compression[0], floatBitsToUint(most));
}
