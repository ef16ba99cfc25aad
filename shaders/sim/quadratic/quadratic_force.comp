// Elastic (and viscous) force of every quadratic tet on its vertices, and its energy, as elastic_force does for linear
// ones, with the inertia of what moves at its centroid. Writes the slots that gradient gathers: xyz l^2 dE/du + M (u - u~)
// [kg m], w of the first corner: l^2 E + 1/2 (u - u~)^T M (u - u~) [kg m^2]; FROM_START: less the latter at the start of the
// stage, as in gradient.
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/quadratic_slots.glsl"
#include "sim/quadratic/law.glsl"
COMPUTE_1D
#include "sim/elasticity/feature_step.glsl"
#if COMPENSATED
INPUT_VEC4(DisplacementLow, displacement_low)  // [vertex_count] the part of u that float32 cannot represent [m]
#endif
INPUT_VEC4(PredictedCentroid, predicted_centroid)  // [quadratic_count] xyz u~ [m], w mass [kg]
#if FROM_START
INPUT_VEC4(StartDisplacement, start_displacement)  // [vertex_count] u at the start of the stage [m]
#endif

PointGradients point_gradients(uint e, Tet tet) {
  uvec4 m = FETCH(mid_edges, 2u * e);
  uvec2 n = FETCH(mid_edges, 2u * e + 1u).xy;
  return at_points(corner_gradients(tet, displacement_of(tet.v.x), displacement_of(tet.v.y), displacement_of(tet.v.z),
                                    displacement_of(tet.v.w), displacement_of(m.x), displacement_of(m.y), displacement_of(m.z),
                                    displacement_of(m.w), displacement_of(n.x), displacement_of(n.y)));
}

// How far the centroid is from its u~, by differences, so that a translation costs no accuracy; w mass.
vec4 lag_of_centroid(uint e, uvec4 c) {
  uvec4 m = FETCH(mid_edges, 2u * e);
  uvec2 n = FETCH(mid_edges, 2u * e + 1u).xy;
  vec4 center = FETCH(predicted_centroid, e);
#define LAG(v) (displacement_of(v) - center.xyz)
  return vec4(AT_CENTROID(LAG, c, m, n), center.w);
}

#if FROM_START
// The way of the centroid in the stage so far [m].
vec3 way_of_centroid(uint e, uvec4 c) {
  uvec4 m = FETCH(mid_edges, 2u * e);
  uvec2 n = FETCH(mid_edges, 2u * e + 1u).xy;
#define WAY(v) (displacement_of(v) - FETCH(start_displacement, v).xyz)
  return AT_CENTROID(WAY, c, m, n);
}
#endif

void main() {
  ITEM_OR_RETURN(e)
  uint t = FIRST_QUADRATIC + e;
  Tet tet = load_tet(t);
  // Apart, or the displacements would stay in registers until they are needed again.
  PointGradients h = NO_GRADIENTS;
  APART(tet, h = point_gradients(e, tet);)
#if COMPENSATED
  PointGradients low = POINT_GRADIENTS(e, tet, displacement_low);
  for (int q = 0; q < 4; ++q) h.at[q] += low.at[q];
#endif
  vec4 material = material_of(t);
#ifdef DEFERS
  if (needs_guard(h, material)) { defer(e); return; }
#endif
  float energy = respond(e, h, material);
  QuadraticForces f = forces_of(tet, h);  // by now, the stresses
  float scale = SUBSTEP * SUBSTEP * tet.volume;
  vec4 lag = vec4(0.0);
  APART(tet, lag = lag_of_centroid(e, tet.v);)
  vec3 inertia = lag.w * lag.xyz, of_corner = CORNER_AT_CENTROID * inertia, of_middle = MIDDLE_AT_CENTROID * inertia;
#if FROM_START
  vec3 way = vec3(0.0);
  APART(tet, way = way_of_centroid(e, tet.v);)
  float kinetic = 0.5 * lag.w * dot(way, 2.0 * lag.xyz - way);
#else
  float kinetic = 0.5 * dot(inertia, lag.xyz);
#endif
  uvec4 slot = FETCH(quadratic_slots, 3u * e);
  correction[slot.x] = vec4(scale * f.corner[0] + of_corner, scale * energy + kinetic);
  STORE3(correction[slot.y], scale * f.corner[1] + of_corner)
  STORE3(correction[slot.z], scale * f.corner[2] + of_corner)
  STORE3(correction[slot.w], scale * f.corner[3] + of_corner)
  slot = FETCH(quadratic_slots, 3u * e + 1u);
  STORE3(correction[slot.x], scale * f.middle[0] + of_middle)
  STORE3(correction[slot.y], scale * f.middle[1] + of_middle)
  STORE3(correction[slot.z], scale * f.middle[2] + of_middle)
  STORE3(correction[slot.w], scale * f.middle[3] + of_middle)
  slot = FETCH(quadratic_slots, 3u * e + 2u);
  STORE3(correction[slot.x], scale * f.middle[4] + of_middle)
  STORE3(correction[slot.y], scale * f.middle[5] + of_middle)
}
