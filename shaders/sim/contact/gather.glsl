// Sums over the points around a vertex.
#include "sim/contact/entry.glsl"
#if FORCES
INPUT_VEC4(ContactForce, contact_force)  // [points] xyz on the tissue [N], w energy [J]

// The first corner carries the energy of a point. xyz dE/du [N], w 2 E [J].
vec4 gathered_gradient(uint v) {
  vec4 sum = vec4(0.0);
#define ADD_FORCE(point, weight, first)           \
  {                                               \
    vec4 force = FETCH(contact_force, point);     \
    sum += vec4(-(weight) * force.xyz, first ? 2.0 * force.w : 0.0); \
  }
  FOR_POINTS_AROUND(v, ADD_FORCE)
  return sum;
}
#endif
#if BLOCKS
INPUT_VEC4(ContactBlock, contact_block)  // [2 * points] xyz of xx, yy, zz then of yz, xz, xy [N/m]

Sym3 gathered_block(uint v, float scale) {
  Sym3 sum = Sym3(vec3(0.0), vec3(0.0));
#define ADD_BLOCK(point, weight, first)                                \
  {                                                                    \
    float factor = scale * (weight) * (weight);                        \
    sum.d += factor * FETCH(contact_block, 2u * (point)).xyz;          \
    sum.s += factor * FETCH(contact_block, 2u * (point) + 1u).xyz;     \
  }
  FOR_POINTS_AROUND(v, ADD_BLOCK)
  return sum;
}
#endif
