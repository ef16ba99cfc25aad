// Elastic (and viscous) force of every quadratic tet on its vertices, and its energy, as elastic_force does for linear
// ones. Writes the slots that gradient gathers: xyz l^2 dE/du [kg m], w of the first corner: l^2 E [kg m^2].
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/quadratic_slots.glsl"
#include "sim/quadratic/law.glsl"
COMPUTE_1D
#include "sim/elasticity/feature_step.glsl"
#if COMPENSATED
INPUT_VEC4(DisplacementLow, displacement_low)  // [vertex_count] the part of u that float32 cannot represent [m]
#endif

void main() {
  ITEM_OR_RETURN(e)
  uint t = FIRST_QUADRATIC + e;
  Tet tet = load_tet(t);
  uvec4 m = FETCH(mid_edges, 2u * e);
  uvec2 n = FETCH(mid_edges, 2u * e + 1u).xy;
  PointGradients h = at_points(corner_gradients(tet, displacement_of(tet.v.x), displacement_of(tet.v.y), displacement_of(tet.v.z),
                                                displacement_of(tet.v.w), displacement_of(m.x), displacement_of(m.y),
                                                displacement_of(m.z), displacement_of(m.w), displacement_of(n.x), displacement_of(n.y)));
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
  correction[slot.x] = vec4(scale * f.corner[0], scale * energy);
  STORE3(correction[slot.y], scale * f.corner[1])
  STORE3(correction[slot.z], scale * f.corner[2])
  STORE3(correction[slot.w], scale * f.corner[3])
  slot = FETCH(quadratic_slots, 3u * e + 1u);
  STORE3(correction[slot.x], scale * f.middle[0])
  STORE3(correction[slot.y], scale * f.middle[1])
  STORE3(correction[slot.z], scale * f.middle[2])
  STORE3(correction[slot.w], scale * f.middle[3])
  slot = FETCH(quadratic_slots, 3u * e + 2u);
  STORE3(correction[slot.x], scale * f.middle[4])
  STORE3(correction[slot.y], scale * f.middle[5])
}
