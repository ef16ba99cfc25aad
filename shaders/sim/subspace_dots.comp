// Sums over the vertices for the step of the subspace: slopes of the objective along the directions z_f, z_c and p (the last step),
// the part of its curvature that vertices carry, the change y of the gradient over the last step, which stands for H p, and the
// objective. After two_level_correct.
#include "common/io.glsl"
#include "common/reduce.glsl"
#include "common/step.glsl"
COMPUTE_1D
INPUT_VEC4(Gradient, gradient)                // [vertex_count] xyz g [kg m], w objective [kg m^2]
INPUT_FLOAT(Mass, mass)                       // [vertex_count] [kg]
INPUT_VEC4(FineDirection, fine_direction)     // [vertex_count] z_f [m]
#if SPLIT
INPUT_VEC4(CoarseDirection, coarse_direction)  // [vertex_count] z_c [m]
#endif
INPUT_VEC4(LastStep, last_step)                  // [vertex_count] p [m]
INPUT_VEC4(PreviousGradient, previous_gradient)  // [vertex_count] g before p [kg m]
#include "sim/feature_grab.glsl"
// Three arrays of `partials`: x g.z_f, y g.z_c, z g.p, w objective; x z_f M z_f, y z_f M z_c, z z_c M z_c, w p M p; x z_f.y, y z_c.y, z p.y
OUTPUT(vec4, DotPartials, dot_partials)
uniform uint vertex_count, partials;

void main() {
  LANE_OR_RETURN(i)
  vec4 slopes = vec4(0.0), masses = vec4(0.0), secants = vec4(0.0);
  for (uint k = i; k < vertex_count; k += invocations) {
    uint v = LISTED_ITEM(k);
    vec4 g = FETCH(gradient, v);
    vec3 zf = FETCH(fine_direction, v).xyz, zc = vec3(0.0), p = FETCH(last_step, v).xyz;
    vec3 y = g.xyz - FETCH(previous_gradient, v).xyz;
#if SPLIT
    zc = FETCH(coarse_direction, v).xyz;
#endif
    float m = FETCH1(mass, v) + SUBSTEP * SUBSTEP * spring_of(v).w;
    slopes += vec4(dot(g.xyz, zf), dot(g.xyz, zc), dot(g.xyz, p), g.w);
    masses += m * vec4(dot(zf, zf), dot(zf, zc), dot(zc, zc), dot(p, p));
    secants += vec4(dot(zf, y), dot(zc, y), dot(p, y), 0.0);
  }
  STORE_PARTIAL(dot_partials, i, slopes)
  STORE_PARTIAL(dot_partials, i + partials * PARTIAL_STRIDE, masses)
  STORE_PARTIAL(dot_partials, i + 2u * partials * PARTIAL_STRIDE, secants)
}
