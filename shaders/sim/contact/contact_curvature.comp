// Curvature of the energy of contact along z_f and z_c, sums over the listed points, behind those of the tets; and how
// the depth of each changes along z_f, z_c and p. After contact_force and two_level_correct.
#include "common/finite.glsl"
#include "common/io.glsl"
#include "common/reduce.glsl"
#include "common/step.glsl"
#include "common/symmetric.glsl"
COMPUTE_1D
#include "sim/contact/point.glsl"
INPUT_VEC4(FineDirection, fine_direction)  // [vertex_count] z_f [m]
#if SPLIT
INPUT_VEC4(CoarseDirection, coarse_direction)  // [vertex_count] z_c [m]
#endif
INPUT_VEC4(LastStep, last_step)                    // [vertex_count] p [m]
INPUT_VEC4(ContactBlock, contact_block)            // [2 * points]
INPUT_VEC4(ContactPressing, contact_pressing)      // [points] contact_force.comp
INPUT_UINT(ContactList, contact_list)              // contact_list.comp
OUTPUT(vec4, ContactAlong, contact_along)            // [listed points] sim/two_level/pressing_step.glsl
OUTPUT(vec4, CurvaturePartials, curvature_partials)  // from first_partial on: x z_f H z_f, y z_f H z_c, z z_c H z_c
uniform uint first_partial;

void main() {
  LANE_OR_RETURN(i)
  vec3 sum = vec3(0.0);
  uint count = FETCH1(contact_list, 3u);
  FOR_ITEMS_OF_LANE(k, i, invocations, count) {
    uint point = FETCH1(contact_list, 4u + k);
    uvec4 vertices = FETCH(contact_vertices, point);
    vec4 weights = FETCH(contact_weights, point);
    Sym3 block = Sym3(FETCH(contact_block, 2u * point).xyz, FETCH(contact_block, 2u * point + 1u).xyz);
    vec3 fine = AT_POINT(fine_direction, vertices, weights), h = times(block, fine);
    sum.x += dot(fine, h);
    vec4 pressing = FETCH(contact_pressing, point);
    vec4 along = vec4(dot(pressing.xyz, fine), 0.0, dot(pressing.xyz, AT_POINT(last_step, vertices, weights)), pressing.w);
#if SPLIT
    vec3 coarse = AT_POINT(coarse_direction, vertices, weights);
    sum.yz += vec2(dot(coarse, h), dot(coarse, times(block, coarse)));
    float along_coarse = dot(pressing.xyz, coarse);
    if (is_finite(along_coarse)) along.y = along_coarse;  // else the step goes without it
#endif
    contact_along[k] = SUBSTEP * along;
  }
  STORE_PARTIAL(curvature_partials, i + first_partial * PARTIAL_STRIDE, vec4(SUBSTEP * SUBSTEP * sum, 0.0))
}
