// Exact XPBD, first of four passes: the force of the multipliers on the corners, G_a^T lambda = F mat(lambda) b_a, and
// the contribution of the tension to a corner's mass, 2 |b_a|^2 |mat(lambda)|, into the slots that exact_vertex
// gathers.
#include "common/io.glsl"
#include "common/tet_pair.glsl"
#include "common/pair_slots.glsl"
#include "sim/material/deformation.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]
INPUT_VEC4(Multiplier, multiplier)      // [2 * tet_count] lambda

struct Tension {
  mat3 force;   // F mat(lambda)
  float raise;  // [kg m^2]
};

Tension tension_of(uint t, mat3 h) {
  mat3 f = deformation_of(h, material_of(t)).f;
  Sym3 lambda = with_halved_shears(FETCH(multiplier, 2u * t).xyz, FETCH(multiplier, 2u * t + 1u).xyz);
  return Tension(times(f, lambda), 2.0 * sqrt(contract(lambda, lambda)));
}

vec4 at_corner(Tension tension, vec3 b) { return vec4(tension.force * b, tension.raise * dot(b, b)); }

void main() {
  ITEM_OR_RETURN(i)
  TetPair pair = load_pair(i);
  PairGradient h = GRADIENTS(pair, displacement);
  DEFER_GUARDED(i, pair, h)
  Tension a = tension_of(pair.ta, h.a), b = tension_of(pair.tb, h.b);
  uvec4 slot = FETCH(pair_slots, i);
  correction[slot.x] = at_corner(a, -(pair.a.b1 + pair.a.b2 + pair.a.b3)) + at_corner(b, -(pair.b.b1 + pair.b.b2 + pair.b.b3));
  correction[slot.y] = at_corner(a, pair.a.b1) + at_corner(b, pair.b.b2);
  correction[slot.z] = at_corner(a, pair.a.b2) + at_corner(b, pair.b.b1);
  correction[slot.w] = at_corner(a, pair.a.b3);
  if (pair.two) correction[pair.fifth_slot] = at_corner(b, pair.b.b3);
}
