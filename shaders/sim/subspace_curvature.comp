// Curvature of the elastic energy along z_f and z_c: sums over the tets of h^2 times
//   V dF_i : d^2 Psi / dF^2 : dF_j,   with damping its viscous part.
// Only the three sums are needed, not the products of the Hessian with the directions. After two_level_correct. With DEFERRED the terms
// of the tets that elastic_force deferred; those of the others and the sums come after it.
#include "common/io.glsl"
#include "common/reduce.glsl"
#include "common/step.glsl"
#include "common/tet.glsl"
#include "sim/elasticity.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)        // [vertex_count] u [m]
INPUT_VEC4(FineDirection, fine_direction)     // [vertex_count] z_f [m]
#if SPLIT
INPUT_VEC4(CoarseDirection, coarse_direction)  // [vertex_count] z_c [m]
#endif
#ifdef DEFERRED
OUTPUT(vec4, GuardedCurvature, guarded_curvature)  // [tet_count] xyz the terms of a guarded tet, w 1
#else
OUTPUT(vec4, CurvaturePartials, curvature_partials)  // x z_f H z_f, y z_f H z_c, z z_c H z_c
uniform uint tet_count;
#ifdef GUARDED_ELSEWHERE
INPUT_VEC4(GuardedTerms, guarded_terms)  // [tet_count] the same, w 0 where not guarded
#endif
#endif

// Of a tet as it stands; `guard`: whether it needs one.
vec3 terms_of(uint t, out bool guard) {
  Tet tet = load_tet(t);
  mat3 h = displacement_gradient(tet, FETCH(displacement, tet.v.x).xyz, FETCH(displacement, tet.v.y).xyz,
                                 FETCH(displacement, tet.v.z).xyz, FETCH(displacement, tet.v.w).xyz);
  vec4 material = material_of(t);
#ifdef GUARDED_ELSEWHERE
  guard = needs_guard(h, material);
#else
  guard = false;
#endif
  Tangent tangent = tangent_of(t, h, material);
  mat3 df = displacement_gradient(tet, FETCH(fine_direction, tet.v.x).xyz, FETCH(fine_direction, tet.v.y).xyz,
                                  FETCH(fine_direction, tet.v.z).xyz, FETCH(fine_direction, tet.v.w).xyz);
  vec3 terms = vec3(curvature(tangent, h, material, df, df), 0.0, 0.0);
#if SPLIT
  mat3 dc = displacement_gradient(tet, FETCH(coarse_direction, tet.v.x).xyz, FETCH(coarse_direction, tet.v.y).xyz,
                                  FETCH(coarse_direction, tet.v.z).xyz, FETCH(coarse_direction, tet.v.w).xyz);
  terms.y = curvature(tangent, h, material, df, dc);
  terms.z = curvature(tangent, h, material, dc, dc);
#endif
  return SUBSTEP * SUBSTEP * tet.volume * terms;
}

#ifdef DEFERRED
void main() {
  ITEM_OR_RETURN(t)
  bool guard;
  guarded_curvature[t] = vec4(terms_of(t, guard), 1.0);
}
#else
void main() {
  LANE_OR_RETURN(i)
  vec3 sum = vec3(0.0);
  FOR_ITEMS_OF_LANE(k, i, invocations, tet_count) {
    uint t = LISTED_ITEM(k);
    bool guard;
    vec3 terms = terms_of(t, guard);
#ifdef GUARDED_ELSEWHERE
    // Upright ones, most of all, read one and the same element. Where rounding makes the two kernels disagree both terms are right.
    vec4 other = FETCH(guarded_terms, guard ? t : 0u);
    if (guard && other.w > 0.0) terms = other.xyz;
#endif
    sum += terms;
  }
  STORE_PARTIAL(curvature_partials, i, vec4(sum, 0.0))
}
#endif
