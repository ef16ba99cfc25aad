// One Jacobi sweep over all tets: every tet solves its block from the same displacements.
// Reads displacement; writes multiplier and one correction per corner into the slots that jacobi_vertex gathers.
#include "common/io.glsl"
#include "sim/xpbd_block.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] xyz u [m], w inverse mass [1/kg]
INPUT_UVEC4(TetSlots, tet_slots)        // [tet_count] where each corner's correction goes
INOUT(vec4, Multiplier, multiplier)     // [2 * tet_count] lambda, xyz of xx, yy, zz then of yz, xz, xy
OUTPUT(vec4, Correction, correction)    // [4 * tet_count]

void main() {
  ITEM_OR_RETURN(t)
  Tet tet = load_tet(t);
#if FIRST_ITERATION
  vec3 lambda_d = vec3(0.0), lambda_s = vec3(0.0);
#else
  vec3 lambda_d = multiplier[2u * t].xyz, lambda_s = multiplier[2u * t + 1u].xyz;
#endif
  BlockStep s = solve_block(t, tet, FETCH(displacement, tet.v.x), FETCH(displacement, tet.v.y),
                            FETCH(displacement, tet.v.z), FETCH(displacement, tet.v.w), lambda_d, lambda_s);
  multiplier[2u * t] = vec4(lambda_d + s.change_d, 0.0);
  multiplier[2u * t + 1u] = vec4(lambda_s + s.change_s, 0.0);
  uvec4 slot = FETCH(tet_slots, t);
  correction[slot.x] = vec4(s.dx0, 0.0);
  correction[slot.y] = vec4(s.dx1, 0.0);
  correction[slot.z] = vec4(s.dx2, 0.0);
  correction[slot.w] = vec4(s.dx3, 0.0);
}
