// Sums of contact at every vertex that it touches, over the points around it: force, energy and stiffness. On software
// renderers, where invocations run in lockstep: kernels over all vertices would wait for the loops of a few. After
// contact_force.
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/symmetric.glsl"
COMPUTE_1D
#define FORCES 1
#define BLOCKS 1
#include "sim/contact/gather.glsl"
OUTPUT(vec4, ContactSums, contact_sums)  // [3 * vertex_count] xyz dE/du [N], w 2 E [J]; xyz h^2 times the stiffness [kg], xx, yy, zz; yz, xz, xy

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
  contact_sums[3u * v] = gradient;
  STORE3(contact_sums[3u * v + 1u], block.d)
  STORE3(contact_sums[3u * v + 2u], block.s)
}
