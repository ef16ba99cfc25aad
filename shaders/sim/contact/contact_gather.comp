// Sums of contact at every vertex that it touches, over the points around it: force, energy and stiffness. On software
// renderers, where invocations run in lockstep: kernels over all vertices would wait for the loops of a few. With INVERTS
// also the inverse of the vertex's block, as block_contact.comp states it. After contact_force.
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/symmetric.glsl"
COMPUTE_1D
#define FORCES 1
#define BLOCKS 1
#include "sim/contact/gather.glsl"
OUTPUT(vec4, ContactSums, contact_sums)  // [3 * vertex_count] xyz dE/du [N], w 2 E [J]; xyz h^2 times the stiffness [kg], xx, yy, zz; yz, xz, xy
#if INVERTS
INPUT_VEC4_IN_PLACE(SumsBefore, sums_before)  // the same of the last forces
INPUT_VEC4(BlockFree, block_free)             // [2 * vertex_count]
#include "sim/two_level/store_inverse.glsl"
#endif

#define ADD(point, weight, first)           \
  ADD_FORCE(gradient, point, weight, first) \
  ADD_BLOCK(block, SUBSTEP * SUBSTEP, point, weight)

void main() {
  ITEM_OR_RETURN(v)
  vec4 gradient = vec4(0.0);
  Sym3 block = Sym3(vec3(0.0), vec3(0.0));
  uint entry = FETCH1(contact_begin, v), end = FETCH1(contact_end, v);
  do ADD_TWO(entry, ADD)
  while (++entry < end);  // there is one; llvmpipe runs the body of other loops once more
#if INVERTS
  Sym3 before = Sym3(FETCH_IN_PLACE(sums_before, 3u * v + 1u).xyz, FETCH_IN_PLACE(sums_before, 3u * v + 2u).xyz);
#endif
  contact_sums[3u * v] = gradient;
  STORE3(contact_sums[3u * v + 1u], block.d)
  STORE3(contact_sums[3u * v + 2u], block.s)
#if INVERTS
  if (trace(before) > trace(block)) block = before;
  vec4 free = FETCH(block_free, 2u * v);
  store_inverse(v, Sym3(free.xyz + block.d, FETCH(block_free, 2u * v + 1u).xyz + block.s), free.w);
#endif
}
