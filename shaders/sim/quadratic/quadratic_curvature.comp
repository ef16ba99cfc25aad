// Curvature of the elastic energy of quadratic tets along z_f and z_c, as subspace_curvature computes it for linear
// ones: sums over the tets of l^2 times
//   V [mean dF_i : d^2 Psi/dF^2 : dF_j + K (mean theta) mean d^2 theta(dF_i, dF_j) + K (mean dtheta(dF_i)) (mean dtheta(dF_j))]
// and with damping the viscous part, and of M z_i . z_j of what moves at their centroids. With DEFERRED it computes the
// terms of the tets that quadratic_force deferred. With LAST_GROUP the last work group also does the work of subspace_solve.
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
INPUT_VEC4(PredictedCentroid, predicted_centroid)  // [quadratic_count] w mass [kg]
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

struct Held {
  PointGradients h, fine;
#if SPLIT
  PointGradients coarse;
#endif
};

// What the terms at a point need of all points.
struct Means {
  float dilatation;  // 4 times theta
  bool guard;        // whether one of the points needs the guard
#if DAMPING
  StrainMeans strain;
#endif
};

void add_means(uint e, int q, Tet tet, PointGradients held, vec4 material, inout Means means) {
  mat3 h = AT_POINT(held, e, tet, q, displacement);
  means.dilatation += dilatation_of(h, material).value;
#ifdef GUARDED_ELSEWHERE
  means.guard = means.guard || needs_guard(h, material);
#endif
#if DAMPING
  add_point(means.strain, e, q, h);
#endif
}

struct Terms {
  vec3 sum;
  vec2 growth;  // mean dtheta along z_f and z_c
#if DAMPING
  Viscosity viscosity;
  vec2 viscous_growth;
#endif
};

#if DAMPING
void add_viscous_terms(uint e, int q, vec4 material, mat3 at, mat3 f, mat3 c, inout Terms terms) {
  Viscosity viscosity = terms.viscosity;
  mat3 deformed = mat3(1.0) + at;
  Sym3 s = viscous_stress_at_point(viscosity, strain_since_start(e, q, at), material);
  s.d += viscosity.bulk * viscosity.mean;
  terms.viscous_growth += 0.25 * vec2(inner(deformed, f), inner(deformed, c));
  Sym3 by_f = strain_change(deformed, f), by_c = strain_change(deformed, c);
  terms.sum.x += contract(viscous_stress_at_point(viscosity, by_f, material), by_f) + geometric(f, s, f);
#if SPLIT
  terms.sum.y += contract(viscous_stress_at_point(viscosity, by_f, material), by_c) + geometric(f, s, c);
  terms.sum.z += contract(viscous_stress_at_point(viscosity, by_c, material), by_c) + geometric(c, s, c);
#endif
}
#endif

void add_terms(uint e, int q, Tet tet, Held held, vec4 material, vec4 pointwise, float pressure, inout Terms terms) {
  mat3 at = mat3(0.0), f = mat3(0.0);
  APART(tet, at = AT_POINT(held.h, e, tet, q, displacement);)
  APART(tet, f = AT_POINT(held.fine, e, tet, q, fine_direction);)
#if SPLIT
  mat3 c = mat3(0.0);
  APART(tet, c = AT_POINT(held.coarse, e, tet, q, coarse_direction);)
#else
  mat3 c = f;
#endif
  Tangent tangent = elastic_tangent_of(at, pointwise);
  mat3 first = dilatation_of(at, material).first;
  terms.growth += 0.25 * vec2(inner(first, f), inner(first, c));
  terms.sum.x += curvature(tangent, at, pointwise, f, f) + pressure * dilatation_curvature(at, material, f, f);
#if SPLIT
  terms.sum.y += curvature(tangent, at, pointwise, f, c) + pressure * dilatation_curvature(at, material, f, c);
  terms.sum.z += curvature(tangent, at, pointwise, c, c) + pressure * dilatation_curvature(at, material, c, c);
#endif
#if DAMPING
  if (terms.viscosity.over_h > 0.0) add_viscous_terms(e, q, material, at, f, c, terms);
#endif
}

vec3 inertia_of(uint e) {
  uvec4 c = FETCH(tet_vertices, FIRST_QUADRATIC + e), m = FETCH(mid_edges, 2u * e);
  uvec2 n = FETCH(mid_edges, 2u * e + 1u).xy;
#define FINE(v) FETCH(fine_direction, v).xyz
  vec3 fine = AT_CENTROID(FINE, c, m, n);
  vec3 terms = vec3(dot(fine, fine), 0.0, 0.0);
#if SPLIT
#define COARSE(v) FETCH(coarse_direction, v).xyz
  vec3 coarse = AT_CENTROID(COARSE, c, m, n);
  terms.yz = vec2(dot(fine, coarse), dot(coarse, coarse));
#endif
  return FETCH(predicted_centroid, e).w * terms;
}

// `guard`: whether one of the points needs the guard.
vec3 terms_of(uint e, out bool guard) {
  uint t = FIRST_QUADRATIC + e;
  Tet tet = load_tet(t);
  vec4 material = material_of(t);
  Held held;
  held.h = HELD(e, tet, displacement);
  held.fine = HELD(e, tet, fine_direction);
#if SPLIT
  held.coarse = HELD(e, tet, coarse_direction);
#endif
  Means means;
  means.dilatation = 0.0;
  means.guard = false;
#if DAMPING
  means.strain = StrainMeans(vec3(0.0), 0.0);
#endif
  for (int q = 0; q < 4; ++q) add_means(e, q, tet, held.h, material, means);
  guard = means.guard;
  VolumeSplit split = volume_split(material);
  VolumeTerm volume = volume_term_of(e, split.bulk, material);
  float pressure = volume.bulk * (0.25 * means.dilatation) + volume.multiplier;
  Terms terms;
  terms.sum = vec3(0.0);
  terms.growth = vec2(0.0);
#if DAMPING
  terms.viscosity = viscosity_of(means.strain, material);
  terms.viscous_growth = vec2(0.0);
#endif
  for (int q = 0; q < 4; ++q) add_terms(e, q, tet, held, material, split.pointwise, pressure, terms);
  vec2 growth = terms.growth;
  vec3 sum = 0.25 * terms.sum + volume.bulk * vec3(growth.x * growth.x, growth.x * growth.y, growth.y * growth.y);
#if DAMPING
  growth = terms.viscous_growth;
  sum += terms.viscosity.bulk * vec3(growth.x * growth.x, growth.x * growth.y, growth.y * growth.y);
#endif
  return SUBSTEP * SUBSTEP * tet.volume * sum + inertia_of(e);
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
