// Inverse of every vertex's 3x3 block, kept for some iterations: a new one each time would cost more than the
// iterations that it saves. After predict and prescribe.
#include "common/io.glsl"
#define GUARDED_ELSEWHERE 1
#define AT_VERTEX(v) FETCH(displacement, v).xyz
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]
#include "sim/elasticity/vertex_block.glsl"
#include "sim/energy/terms.glsl"
INPUT_FLOAT(Mass, mass)                     // [vertex_count] [kg]
OUTPUT(vec4, BlockInverse, block_inverse)  // [2 * vertex_count] xyz of xx, yy, zz then of yz, xz, xy [1/kg]

void main() {
  ITEM_OR_RETURN(i)
  Sym3 a = add_tets(i).hessian;
  a.d += FETCH1(mass, i) + external_stiffness(i, SUBSTEP * SUBSTEP);
  // Scaled to a unit trace: the determinant of a small mesh's block would exceed the range of floats.
  float scale = 1.0 / (a.d.x + a.d.y + a.d.z);
  Sym3 inverse = inverse_of(Sym3(scale * a.d, scale * a.s));
  STORE3(block_inverse[2u * i], scale * inverse.d)
  STORE3(block_inverse[2u * i + 1u], scale * inverse.s)
}
