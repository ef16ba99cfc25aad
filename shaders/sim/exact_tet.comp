// Exact XPBD, first of four passes: the force of the multipliers on the corners, G_a^T lambda = F mat(lambda) b_a, and what the
// tension adds to a corner's mass, 2 |b_a|^2 |mat(lambda)|, into the slots that exact_vertex gathers.
#include "common/io.glsl"
#include "common/tet.glsl"
#include "sim/material/deformation.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]
INPUT_VEC4(Multiplier, multiplier)      // [2 * tet_count] lambda
INPUT_UVEC4(TetSlots, tet_slots)        // [tet_count]
OUTPUT(vec4, Correction, correction)    // [4 * tet_count] xyz [kg m], w [kg]

void main() {
  ITEM_OR_RETURN(t)
  Tet tet = load_tet(t);
  mat3 h = displacement_gradient(tet, FETCH(displacement, tet.v.x).xyz, FETCH(displacement, tet.v.y).xyz,
                                 FETCH(displacement, tet.v.z).xyz, FETCH(displacement, tet.v.w).xyz);
  DEFER_GUARDED(t, h)
  mat3 f = deformation_of(h, material_of(t)).f;
  Sym3 lambda = with_halved_shears(FETCH(multiplier, 2u * t).xyz, FETCH(multiplier, 2u * t + 1u).xyz);
  float tension = 2.0 * sqrt(contract(lambda, lambda));
  vec3 b0 = -(tet.b1 + tet.b2 + tet.b3);
  uvec4 slot = FETCH(tet_slots, t);
  correction[slot.x] = vec4(f * times(lambda, b0), tension * dot(b0, b0));
  correction[slot.y] = vec4(f * times(lambda, tet.b1), tension * dot(tet.b1, tet.b1));
  correction[slot.z] = vec4(f * times(lambda, tet.b2), tension * dot(tet.b2, tet.b2));
  correction[slot.w] = vec4(f * times(lambda, tet.b3), tension * dot(tet.b3, tet.b3));
}
