// Contact with tools, gathered at a vertex from the points around it (sim/contact/contact_force.comp). CONTACT 1: forces
// and energies, 2: stiffness. On software renderers contact_gather.comp has summed both.
#if READ_TEXELS
INPUT_VEC4(ContactSums, contact_sums)  // [3 * vertex_count]
#else
#define FORCES (CONTACT == 1)
#define BLOCKS (CONTACT == 2)
#include "sim/contact/gather.glsl"
#endif

#if CONTACT == 1
vec4 contact_gradient(uint v, vec3 u, float scale) {
#if READ_TEXELS
  return scale * FETCH(contact_sums, 3u * v);
#else
  vec4 sum = vec4(0.0);
#define ADD(point, weight, first) ADD_FORCE(sum, point, weight, first)
  FOR_POINTS_AROUND(v, ADD)
  return scale * sum;
#endif
}
#else
Sym3 contact_block_of(uint v, float scale) {  // `scale`: h^2
#if READ_TEXELS
  return Sym3(FETCH(contact_sums, 3u * v + 1u).xyz, FETCH(contact_sums, 3u * v + 2u).xyz);
#else
  Sym3 sum = Sym3(vec3(0.0), vec3(0.0));
#define ADD(point, weight, first) ADD_BLOCK(sum, scale, point, weight)
  FOR_POINTS_AROUND(v, ADD)
  return sum;
#endif
}
#endif
