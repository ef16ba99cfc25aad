// Elastic (and viscous) force of every tet on its corners, and its energy: the terms of tets in the objective of an implicit Euler
// step, 1/2 (u - u~)^T M (u - u~) + h^2 sum V [Psi(eps) + damping/h Psi(eps - eps_n)].
// Reads displacement; writes the slots that gradient gathers: xyz h^2 V P b_a [kg m], w of the first corner's the energy [kg m^2].
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/tet.glsl"
#include "sim/elasticity.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]
#if COMPENSATED
INPUT_VEC4(DisplacementLow, displacement_low)  // [vertex_count] what float32 cannot hold of u [m]
#endif
INPUT_UVEC4(TetSlots, tet_slots)        // [tet_count]
OUTPUT(vec4, Correction, correction)    // [4 * tet_count]

void main() {
  ITEM_OR_RETURN(t)
  Tet tet = load_tet(t);
  mat3 h = displacement_gradient(tet, FETCH(displacement, tet.v.x).xyz, FETCH(displacement, tet.v.y).xyz,
                                 FETCH(displacement, tet.v.z).xyz, FETCH(displacement, tet.v.w).xyz);
#if COMPENSATED
  h += displacement_gradient(tet, FETCH(displacement_low, tet.v.x).xyz, FETCH(displacement_low, tet.v.y).xyz,
                             FETCH(displacement_low, tet.v.z).xyz, FETCH(displacement_low, tet.v.w).xyz);
#endif
  DEFER_GUARDED(t, h)
  Elastic response = response_of(t, h, material_of(t));
  float scale = SUBSTEP * SUBSTEP * tet.volume;
  vec3 f1 = scale * (response.p * tet.b1), f2 = scale * (response.p * tet.b2), f3 = scale * (response.p * tet.b3);
  uvec4 slot = FETCH(tet_slots, t);
  correction[slot.x] = vec4(-(f1 + f2 + f3), scale * response.energy);
  STORE3(correction[slot.y], f1)
  STORE3(correction[slot.z], f2)
  STORE3(correction[slot.w], f3)
}
