// One Jacobi sweep over all tets, in pairs: every tet solves its block from the same displacements. With EXACT each
// vertex will also move by -g/m^ (exact_vertex.comp), which the tets take into account.
// Reads displacement; writes multiplier and one correction per corner of a pair into the slots that jacobi_vertex
// gathers.
#include "common/io.glsl"
#include "common/tet_pair.glsl"
#include "common/pair_slots.glsl"
#include "sim/xpbd/xpbd_block.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] xyz u [m], w inverse mass [1/kg]
INPUT_VEC4_IN_PLACE(Lambda, lambda)     // [2 * tet_count] multiplier: xyz of xx, yy, zz then of yz, xz, xy
OUTPUT(vec4, Multiplier, multiplier)
#if EXACT
INPUT_VEC4(PrimalStep, primal_step)     // [vertex_count] xyz g/m^ [m]
#endif

struct Multiplier6 {
  vec3 d, s;
};

Multiplier6 multiplier_of(uint t) {
#if FIRST_ITERATION
  return Multiplier6(vec3(0.0), vec3(0.0));
#else
  return Multiplier6(FETCH_IN_PLACE(lambda, 2u * t).xyz, FETCH_IN_PLACE(lambda, 2u * t + 1u).xyz);
#endif
}

// Returns the corrections and stores the multiplier.
BlockStep solve(uint t, bool stored, Tet tet, mat3 h, vec4 inverse_mass, Sym3 foreseen) {
  Multiplier6 before = multiplier_of(t);
  BlockStep s = solve_block(t, tet, h, inverse_mass, before.d, before.s, foreseen);
  if (stored) {
    STORE3(multiplier[2u * t], before.d + s.change_d)
    STORE3(multiplier[2u * t + 1u], before.s + s.change_s)
  }
  return s;
}

void main() {
  ITEM_OR_RETURN(i)
  TetPair pair = load_pair(i);
  vec4 s0 = FETCH(displacement, pair.a.v.x), s1 = FETCH(displacement, pair.a.v.y), s2 = FETCH(displacement, pair.a.v.z),
       x = FETCH(displacement, pair.a.v.w), y = FETCH(displacement, pair.b.v.w);
  PairGradient h = gradients(pair, s0.xyz, s1.xyz, s2.xyz, x.xyz, y.xyz);
  DEFER_GUARDED(i, pair, h)
#if EXACT
  PairGradient step = GRADIENTS(pair, primal_step);
#define FORESEEN(h, t, step) strain_change(deformation_of(h, material_of(t)).f, step)
#else
#define FORESEEN(h, t, step) Sym3(vec3(0.0), vec3(0.0))
#endif
  BlockStep a = solve(pair.ta, true, pair.a, h.a, vec4(s0.w, s1.w, s2.w, x.w), FORESEEN(h.a, pair.ta, step.a));
  BlockStep b = solve(pair.tb, pair.two, pair.b, h.b, vec4(s0.w, s2.w, s1.w, y.w), FORESEEN(h.b, pair.tb, step.b));
  uvec4 slot = FETCH(pair_slots, i);
  STORE3(correction[slot.x], a.dx0 + b.dx0)
  STORE3(correction[slot.y], a.dx1 + b.dx2)
  STORE3(correction[slot.z], a.dx2 + b.dx1)
  STORE3(correction[slot.w], a.dx3)
  if (pair.two) STORE3(correction[pair.fifth_slot], b.dx3)
}
