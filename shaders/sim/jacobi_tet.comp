// One Jacobi sweep over all tets: every tet solves its block from the same displacements. With EXACT each vertex will also move by
// -g/m^ (exact_vertex.comp), which the tets foresee.
// Reads displacement; writes multiplier and one correction per corner into the slots that jacobi_vertex gathers.
#include "common/io.glsl"
#include "sim/xpbd_block.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] xyz u [m], w inverse mass [1/kg]
INPUT_UVEC4(TetSlots, tet_slots)        // [tet_count] where each corner's correction goes
INPUT_VEC4_IN_PLACE(Lambda, lambda)     // [2 * tet_count] multiplier: xyz of xx, yy, zz then of yz, xz, xy
OUTPUT(vec4, Multiplier, multiplier)
#if EXACT
INPUT_VEC4(PrimalStep, primal_step)     // [vertex_count] xyz g/m^ [m]
#endif
OUTPUT(vec4, Correction, correction)    // [4 * tet_count]

void main() {
  ITEM_OR_RETURN(t)
  Tet tet = load_tet(t);
#if FIRST_ITERATION
  vec3 lambda_d = vec3(0.0), lambda_s = vec3(0.0);
#else
  vec3 lambda_d = FETCH(lambda, 2u * t).xyz, lambda_s = FETCH(lambda, 2u * t + 1u).xyz;
#endif
  vec4 u0 = FETCH(displacement, tet.v.x), u1 = FETCH(displacement, tet.v.y), u2 = FETCH(displacement, tet.v.z),
       u3 = FETCH(displacement, tet.v.w);
  mat3 h = displacement_gradient(tet, u0.xyz, u1.xyz, u2.xyz, u3.xyz);
  DEFER_GUARDED(t, h)
  Sym3 foreseen = Sym3(vec3(0.0), vec3(0.0));
#if EXACT
  mat3 f = deformation_of(h, material_of(t)).f;
  foreseen = strain_change(f, displacement_gradient(tet, FETCH(primal_step, tet.v.x).xyz, FETCH(primal_step, tet.v.y).xyz,
                                                    FETCH(primal_step, tet.v.z).xyz, FETCH(primal_step, tet.v.w).xyz));
#endif
  BlockStep s = solve_block(t, tet, u0, u1, u2, u3, lambda_d, lambda_s, foreseen);
  STORE3(multiplier[2u * t], lambda_d + s.change_d)
  STORE3(multiplier[2u * t + 1u], lambda_s + s.change_s)
  uvec4 slot = FETCH(tet_slots, t);
  STORE3(correction[slot.x], s.dx0)
  STORE3(correction[slot.y], s.dx1)
  STORE3(correction[slot.z], s.dx2)
  STORE3(correction[slot.w], s.dx3)
}
