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
#include "sim/two_level/store_inverse.glsl"

void main() {
  ITEM_OR_RETURN(i)
  Sym3 a = add_tets(i).hessian;
  a.d += FETCH1(mass, i) + external_stiffness(i, SUBSTEP * SUBSTEP);
  ADD_EXTERNAL_BLOCK(a, i, SUBSTEP * SUBSTEP)
  store_inverse(i, a);
}
