// Terms of the sums over the points around a vertex (entry.glsl).
#include "sim/contact/entry.glsl"
#if FORCES
INPUT_VEC4(ContactForce, contact_force)  // [points] xyz on the tissue [N], w energy [J]

// To xyz dE/du [N], w 2 E [J]. The first corner carries the energy of a point.
#define ADD_FORCE(sum, point, weight, first)                          \
  {                                                                   \
    vec4 force = FETCH(contact_force, point);                         \
    sum += vec4(-(weight) * force.xyz, (first) ? 2.0 * force.w : 0.0); \
  }
#endif
#if BLOCKS
INPUT_VEC4(ContactBlock, contact_block)  // [2 * points] xyz of xx, yy, zz then of yz, xz, xy [N/m]

#define ADD_BLOCK(sum, scale, point, weight)                       \
  {                                                                \
    float factor = (scale) * (weight) * (weight);                  \
    sum.d += factor * FETCH(contact_block, 2u * (point)).xyz;      \
    sum.s += factor * FETCH(contact_block, 2u * (point) + 1u).xyz; \
  }
#endif
