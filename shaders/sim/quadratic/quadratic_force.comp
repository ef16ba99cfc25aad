// Elastic (and viscous) force of every quadratic tet on its vertices, and its energy, as elastic_force does for linear
// ones, with the inertia of what moves at its centroid. Writes the slots that gradient gathers: xyz l^2 dE/du + M (u - u~)
// [kg m], w of the first corner: l^2 E + 1/2 (u - u~)^T M (u - u~) [kg m^2].
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

void main() {
  ITEM_OR_RETURN(e)
  uint t = FIRST_QUADRATIC + e;
  Tet tet = load_tet(t);
  uvec4 m = FETCH(mid_edges, 2u * e);
  uvec2 n = FETCH(mid_edges, 2u * e + 1u).xy;
  vec3 m01 = displacement_of(m.x), m12 = displacement_of(m.y), m02 = displacement_of(m.z), m03 = displacement_of(m.w),
       m13 = displacement_of(n.x), m23 = displacement_of(n.y);
  vec4 center = FETCH(predicted_centroid, e);
  // Differences, so that a translation costs no accuracy
  vec3 lag = ((m01 - center.xyz) + (m12 - center.xyz) + (m02 - center.xyz) + (m03 - center.xyz) + (m13 - center.xyz) +
              (m23 - center.xyz)) / 6.0;
  vec3 inertia = center.w / 6.0 * lag;  // share of a middle
  PointGradients h = at_points(corner_gradients(tet, displacement_of(tet.v.x), displacement_of(tet.v.y), displacement_of(tet.v.z),
                                                displacement_of(tet.v.w), m01, m12, m02, m03, m13, m23));
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
  uvec4 slot = FETCH(quadratic_slots, 3u * e);
  correction[slot.x] = vec4(scale * f.corner[0], scale * energy + 3.0 * dot(inertia, lag));
  STORE3(correction[slot.y], scale * f.corner[1])
  STORE3(correction[slot.z], scale * f.corner[2])
  STORE3(correction[slot.w], scale * f.corner[3])
  slot = FETCH(quadratic_slots, 3u * e + 1u);
  STORE3(correction[slot.x], scale * f.middle[0] + inertia)
  STORE3(correction[slot.y], scale * f.middle[1] + inertia)
  STORE3(correction[slot.z], scale * f.middle[2] + inertia)
  STORE3(correction[slot.w], scale * f.middle[3] + inertia)
  slot = FETCH(quadratic_slots, 3u * e + 2u);
  STORE3(correction[slot.x], scale * f.middle[4] + inertia)
  STORE3(correction[slot.y], scale * f.middle[5] + inertia)
}
