// Curvature of the elastic energy along z_f and z_c: sums over the pairs of tets of h^2 times
//   V dF_i : d^2 Psi / dF^2 : dF_j,   and with damping its viscous part.
// Only the three sums are needed, not the products of the Hessian with the directions. After two_level_correct. With
// DEFERRED it computes the terms of the tets that elastic_force deferred; the terms of the others and the sums follow. With
// LAST_GROUP the last work group also does the work of subspace_solve.
#include "common/io.glsl"
#include "common/reduce.glsl"
#include "common/step.glsl"
#include "common/tet_pair.glsl"
#include "sim/elasticity/elasticity.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)        // [vertex_count] u [m]
INPUT_VEC4(FineDirection, fine_direction)     // [vertex_count] z_f [m]
#if SPLIT
INPUT_VEC4(CoarseDirection, coarse_direction)  // [vertex_count] z_c [m]
#endif
#ifdef DEFERRED
OUTPUT(vec4, GuardedCurvature, guarded_curvature)  // [pairs and single tets] xyz terms of a pair with a guarded tet, w
                                                   // 1
#else
#ifdef LAST_GROUP
COHERENT(vec4, DotPartials, dot_partials)
#define curvature_partials dot_partials
uniform uint partials;
#define FINAL 0
#include "common/last_group.glsl"
#include "sim/two_level/subspace_step.glsl"
#else
OUTPUT(vec4, CurvaturePartials, curvature_partials)
#endif
// The partials, from first_partial on: x z_f H z_f, y z_f H z_c, z z_c H z_c
uniform uint pair_and_single_count, first_partial;
#ifdef GUARDED_ELSEWHERE
INPUT_VEC4(GuardedTerms, guarded_terms)  // [the same] w 0 if not guarded
#endif
#endif

vec3 terms_of(uint t, Tet tet, mat3 h, mat3 df, mat3 dc) {
  vec4 material = material_of(t);
  Tangent tangent = tangent_of(t, h, material);
  vec3 terms = vec3(curvature(tangent, h, material, df, df), 0.0, 0.0);
#if SPLIT
  terms.y = curvature(tangent, h, material, df, dc);
  terms.z = curvature(tangent, h, material, dc, dc);
#endif
  return tet.volume * terms;
}

// Adds the terms of one tet of pair i; `guard`: whether it needs the guard, or one before did.
void add_terms(uint i, bool second, inout vec3 terms, inout bool guard) {
  TetPair pair = load_pair(i);
  mat3 h = GRADIENT(pair, second, displacement);
#ifdef GUARDED_ELSEWHERE
  guard = guard || needs_guard(h, material_of(second ? pair.tb : pair.ta));
#endif
  mat3 fine = GRADIENT(pair, second, fine_direction);
#if SPLIT
  mat3 coarse = GRADIENT(pair, second, coarse_direction);
#else
  mat3 coarse = fine;
#endif
  Tet tet = pair.a;
  if (second) tet = second_of(pair);
  terms += terms_of(second ? pair.tb : pair.ta, tet, h, fine, coarse);
}

// Terms of a pair as stored; `guard`: whether one of its tets needs the guard.
vec3 terms_of(uint i, out bool guard) {
  vec3 terms = vec3(0.0);
  guard = false;
  FOR_TETS_OF_PAIR(second, i < pair_count, add_terms(i, second, terms, guard);)
  return SUBSTEP * SUBSTEP * terms;
}

#ifdef DEFERRED
void main() {
  ITEM_OR_RETURN(i)
  bool guard;
  guarded_curvature[i] = vec4(terms_of(i, guard), 1.0);
}
#else
void main() {
  LANE_OR_RETURN(i)
  vec3 sum = vec3(0.0);
  FOR_ITEMS_OF_LANE(k, i, invocations, pair_and_single_count) {
    uint pair = LISTED_ITEM(k);
    bool guard;
    vec3 terms = terms_of(pair, guard);
#ifdef GUARDED_ELSEWHERE
    // Upright pairs, the great majority, all read the same element. If the two kernels disagree because of rounding,
    // both results are correct.
    vec4 other = FETCH(guarded_terms, guard ? pair : 0u);
    if (guard && other.w > 0.0) terms = other.xyz;
#endif
    sum += terms;
  }
  STORE_PARTIAL(curvature_partials, i + first_partial * PARTIAL_STRIDE, vec4(sum, 0.0))
#ifdef LAST_GROUP
  if (is_last_group()) solve_subspace_step(gl_LocalInvocationID.x);
#endif
}
#endif
