// Sums over the vertices for the step of the subspace: slopes of the objective along the directions z_f, z_c and p (the
// last step), the part of its curvature that vertices carry, the change y of the gradient over the last step, which
// approximates H p, and the objective. For kernels that have declared `gradient`.
#include "common/reduce.glsl"
#include "common/step.glsl"
#include "sim/energy/terms.glsl"
INPUT_FLOAT(Mass, mass)                          // [vertex_count] the vertices' own masses [kg]
INPUT_VEC4(LastStep, last_step)                  // [vertex_count] p [m]
INPUT_VEC4(PreviousGradient, previous_gradient)  // [vertex_count] g before p [kg m]
// Three arrays of `partials`: x g.z_f, y g.z_c, z g.p, w objective; x z_f M z_f, y z_f M z_c, z z_c M z_c, w p M p; x
// z_f.y, y z_c.y, z p.y
OUTPUT(vec4, DotPartials, dot_partials)
uniform uint vertex_count, partials;

struct SubspaceSums {
  vec4 slopes, masses, secants;
};

void add_vertex(inout SubspaceSums sums, uint v, vec3 fine, vec3 coarse) {
  vec4 g = FETCH(gradient, v);
  vec3 p = FETCH(last_step, v).xyz, y = g.xyz - FETCH(previous_gradient, v).xyz;
  float m = FETCH1(mass, v) + external_stiffness(v, SUBSTEP * SUBSTEP);
  sums.slopes += vec4(dot(g.xyz, fine), dot(g.xyz, coarse), dot(g.xyz, p), g.w);
  sums.masses += m * vec4(dot(fine, fine), dot(fine, coarse), dot(coarse, coarse), dot(p, p));
  sums.secants += vec4(dot(fine, y), dot(coarse, y), dot(p, y), 0.0);
}

void store_sums(SubspaceSums sums, uint lane) {
  STORE_PARTIAL(dot_partials, lane, sums.slopes)
  STORE_PARTIAL(dot_partials, lane + partials * PARTIAL_STRIDE, sums.masses)
  STORE_PARTIAL(dot_partials, lane + 2u * partials * PARTIAL_STRIDE, sums.secants)
}
