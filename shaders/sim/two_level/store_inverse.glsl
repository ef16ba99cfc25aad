// The inverse of a vertex's block, as it is kept for some iterations.
#include "sim/elasticity/symmetric_inverse.glsl"
OUTPUT(vec4, BlockInverse, block_inverse)  // [2 * vertex_count] xyz of xx, yy, zz then of yz, xz, xy [1/kg]; first w as
                                           // `inverse_mass`

// `inverse_mass`: 0 where constrained. Scaled to a unit trace: the determinant of a small mesh's block would exceed the range of floats.
void store_inverse(uint i, Sym3 a, float inverse_mass) {
  float scale = 1.0 / (a.d.x + a.d.y + a.d.z);
  Sym3 inverse = inverse_of(Sym3(scale * a.d, scale * a.s));
  block_inverse[2u * i] = vec4(scale * inverse.d, inverse_mass);
  STORE3(block_inverse[2u * i + 1u], scale * inverse.s)
}
