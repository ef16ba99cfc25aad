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

// Returns the corrections and stores the multiplier. `step`: gradient of the primal step.
BlockStep solve(uint t, Tet tet, mat3 h, mat3 step, vec4 inverse_mass) {
  Deformation deformation = deformation_of(h, material_of(t));
#if EXACT
  Sym3 foreseen = strain_change(deformation.f, step);
#else
  Sym3 foreseen = Sym3(vec3(0.0), vec3(0.0));
#endif
  Multiplier6 before = multiplier_of(t);
  BlockStep s = solve_block(t, tet, h, deformation, inverse_mass, before.d, before.s, foreseen);
  STORE3(multiplier[2u * t], before.d + s.change_d)
  STORE3(multiplier[2u * t + 1u], before.s + s.change_s)
  return s;
}

struct Corrections {
  vec3 s0, s1, s2;
};

void solve_one(uint i, bool second, uvec4 slot, inout Corrections sum) {
  TetPair pair = load_pair(i);
  Tet tet = pair.a;
  if (second) tet = second_of(pair);
  mat3 h = GRADIENT(pair, second, displacement), step = mat3(0.0);
#if EXACT
  step = GRADIENT(pair, second, primal_step);
#endif
  BlockStep s = solve(second ? pair.tb : pair.ta, tet, h, step,
                      vec4(FETCH(displacement, tet.v.x).w, FETCH(displacement, tet.v.y).w, FETCH(displacement, tet.v.z).w,
                           FETCH(displacement, tet.v.w).w));
  sum.s0 += s.dx0;
  sum.s1 += second ? s.dx2 : s.dx1;
  sum.s2 += second ? s.dx1 : s.dx2;
  STORE3(correction[second ? pair.fifth_slot : slot.w], s.dx3)
}

void main() {
  ITEM_OR_RETURN(i)
#ifdef DEFERS
  {
    TetPair pair = load_pair(i);
    PairGradient h = GRADIENTS(pair, displacement);
    DEFER_GUARDED(i, pair, h)
  }
#endif
  uvec4 slot = FETCH(pair_slots, i);
  Corrections sum = Corrections(vec3(0.0), vec3(0.0), vec3(0.0));
  FOR_TETS_OF_PAIR(second, i < pair_count, solve_one(i, second, slot, sum);)
  STORE3(correction[slot.x], sum.s0)
  STORE3(correction[slot.y], sum.s1)
  STORE3(correction[slot.z], sum.s2)
}
