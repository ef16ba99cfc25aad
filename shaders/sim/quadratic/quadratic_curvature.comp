// Curvature of the elastic energy of quadratic tets along z_f and z_c, as subspace_curvature computes it for linear
// ones: sums over the tets of l^2 times
//   V [mean dF_i : d^2 Psi/dF^2 : dF_j + K (mean theta) mean d^2 theta(dF_i, dF_j) + K (mean dtheta(dF_i)) (mean dtheta(dF_j))]
// and with damping the viscous part. With DEFERRED it computes the terms of the tets that quadratic_force deferred. With
// LAST_GROUP the last work group also does the work of subspace_solve.
#include "common/io.glsl"
#include "common/reduce.glsl"
#include "common/step.glsl"
#include "sim/quadratic/law.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)     // [vertex_count] u [m]
INPUT_VEC4(FineDirection, fine_direction)  // [vertex_count] z_f [m]
#if SPLIT
INPUT_VEC4(CoarseDirection, coarse_direction)  // [vertex_count] z_c [m]
#endif
#ifdef DEFERRED
OUTPUT(vec4, GuardedCurvature, guarded_curvature)  // [quadratic_count] xyz terms of a tet with a guarded point, w 1
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
uniform uint quadratic_count, first_partial;
#ifdef GUARDED_ELSEWHERE
INPUT_VEC4(GuardedTerms, guarded_terms)  // [the same] w 0 if not guarded
#endif
#endif

// `guard`: whether one of the points needs the guard.
vec3 terms_of(uint e, out bool guard) {
  uint t = FIRST_QUADRATIC + e;
  Tet tet = load_tet(t);
  PointGradients h = POINT_GRADIENTS(e, tet, displacement), fine = POINT_GRADIENTS(e, tet, fine_direction);
#if SPLIT
  PointGradients coarse = POINT_GRADIENTS(e, tet, coarse_direction);
#else
  PointGradients coarse = fine;
#endif
  vec4 material = material_of(t);
#ifdef GUARDED_ELSEWHERE
  guard = needs_guard(h, material);
#else
  guard = false;
#endif
  VolumeSplit split = volume_split(material);
  float pressure = split.bulk * mean_dilatation(h, material);
#if DAMPING
  Viscosity viscosity = viscosity_of(e, h, material);
  vec2 viscous_growth = vec2(0.0);
#endif
  vec3 terms = vec3(0.0);
  vec2 growth = vec2(0.0);  // mean dtheta along z_f and z_c
  for (int q = 0; q < 4; ++q) {
    mat3 at = h.at[q], f = fine.at[q], c = coarse.at[q];
    Tangent tangent = elastic_tangent_of(at, split.pointwise);
    mat3 first = dilatation_of(at, material).first;
    growth += 0.25 * vec2(inner(first, f), inner(first, c));
    terms.x += curvature(tangent, at, split.pointwise, f, f) + pressure * dilatation_curvature(at, material, f, f);
#if SPLIT
    terms.y += curvature(tangent, at, split.pointwise, f, c) + pressure * dilatation_curvature(at, material, f, c);
    terms.z += curvature(tangent, at, split.pointwise, c, c) + pressure * dilatation_curvature(at, material, c, c);
#endif
#if DAMPING
    mat3 deformed = mat3(1.0) + at;
    Sym3 s = viscous_stress_at_point(viscosity, strain_since_start(e, q, at), material);
    s.d += viscosity.bulk * viscosity.mean;
    viscous_growth += 0.25 * vec2(inner(deformed, f), inner(deformed, c));
    Sym3 by_f = strain_change(deformed, f), by_c = strain_change(deformed, c);
    terms.x += contract(viscous_stress_at_point(viscosity, by_f, material), by_f) + geometric(f, s, f);
#if SPLIT
    terms.y += contract(viscous_stress_at_point(viscosity, by_f, material), by_c) + geometric(f, s, c);
    terms.z += contract(viscous_stress_at_point(viscosity, by_c, material), by_c) + geometric(c, s, c);
#endif
#endif
  }
  terms = 0.25 * terms + split.bulk * vec3(growth.x * growth.x, growth.x * growth.y, growth.y * growth.y);
#if DAMPING
  terms += viscosity.bulk * vec3(viscous_growth.x * viscous_growth.x, viscous_growth.x * viscous_growth.y, viscous_growth.y * viscous_growth.y);
#endif
  return SUBSTEP * SUBSTEP * tet.volume * terms;
}

#ifdef DEFERRED
void main() {
  ITEM_OR_RETURN(e)
  bool guard;
  guarded_curvature[e] = vec4(terms_of(e, guard), 1.0);
}
#else
void main() {
  LANE_OR_RETURN(i)
  vec3 sum = vec3(0.0);
  FOR_ITEMS_OF_LANE(k, i, invocations, quadratic_count) {
    uint e = LISTED_ITEM(k);
    bool guard;
    vec3 terms = terms_of(e, guard);
#ifdef GUARDED_ELSEWHERE
    vec4 other = FETCH(guarded_terms, guard ? e : 0u);  // as in subspace_curvature
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
