// Inverse of every vertex's 3x3 block, kept for some iterations: a new one each time would cost more than the
// iterations that it saves. With FREE the blocks without those of external energies, too, to which block_contact.comp adds
// them; on software renderers it is done here, and by contact_gather.comp. After predict and prescribe.
#include "common/io.glsl"
#define GUARDED_ELSEWHERE 1
#define AT_VERTEX(v) FETCH(displacement, v).xyz
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] xyz u [m], w inverse mass, 0 where constrained
#include "sim/material/invariants.glsl"
#include "sim/elasticity/elasticity.glsl"
#if LINEAR_TETS
#include "sim/elasticity/vertex_block.glsl"
#endif
#if QUADRATIC_TETS
#include "sim/quadratic/vertex_block.glsl"
#endif
#include "sim/energy/terms.glsl"
INPUT_FLOAT(Mass, mass)                     // [vertex_count] the vertices' own masses [kg]
#if FREE
OUTPUT(vec4, BlockFree, block_free)  // [2 * vertex_count] the blocks, xyz of xx, yy, zz then of yz, xz, xy [kg];
                                     // first w inverse mass
#endif
#if !FREE || READ_TEXELS
#include "sim/two_level/store_inverse.glsl"
#endif

void main() {
  ITEM_OR_RETURN(i)
  Sym3 a = Sym3(vec3(0.0), vec3(0.0));
#if LINEAR_TETS
  a = add_tets(i).hessian;
#endif
#if QUADRATIC_TETS
  Sym3 more = quadratic_block(i);
  a = Sym3(a.d + more.d, a.s + more.s);
#endif
  a.d += FETCH1(mass, i) + external_stiffness(i, SUBSTEP * SUBSTEP);
#if FREE
  block_free[2u * i] = vec4(a.d, FETCH(displacement, i).w);
  STORE3(block_free[2u * i + 1u], a.s)
  ADD_EXTERNAL_BLOCK(a, i, SUBSTEP * SUBSTEP)
#endif
#if !FREE || READ_TEXELS
  store_inverse(i, a, FETCH(displacement, i).w);
#endif
}
