// Both corrections of every vertex: of its own block, z_f = H_ii^-1 g, and of the coarse space, z_c = P times the
// nodes' corrections; and, unless they form a sweep, the sums for the step along them. After gradient and, with COARSE,
// coarse_solve.
#include "common/io.glsl"
#include "common/symmetric.glsl"
COMPUTE_1D
INPUT_VEC4(Gradient, gradient)           // [vertex_count] xyz g [kg m], w objective [kg m^2]
INPUT_VEC4(BlockInverse, block_inverse)  // [2 * vertex_count] store_inverse.glsl
#if COARSE
INPUT_UINT(CoarseRowBegin, coarse_row_begin)     // [vertex_count + 1]
INPUT_UVEC4(CoarseRows, coarse_rows)             // two entries each: node and weight (float bits) alternating
INPUT_VEC4(CoarseCorrection, coarse_correction)  // [node_count] [m]
#endif
OUTPUT(vec4, FineDirection, fine_direction)  // [vertex_count] z_f [m]; without SPLIT the sum of both, with SWEEP the
                                             // swept u
#if SPLIT
OUTPUT(vec4, CoarseDirection, coarse_direction)  // [vertex_count] z_c [m]; with SWEEP the sum of both
#endif
#if SWEEP
// u - 0.4 (z_f + z_c): near the minimum the largest eigenvalue of the preconditioned Hessian was never observed above
// 2.3, so this is a contraction.
#define RELAXATION 0.4
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]
OUTPUT(vec4, Iterate, iterate)          // [vertex_count] u [m]
#else
#include "sim/two_level/subspace_sums.glsl"
#endif

void correct(uint i, out vec3 fine, out vec3 coarse) {
  fine = vec3(0.0);
  coarse = vec3(0.0);
  vec4 inverse = FETCH(block_inverse, 2u * i);
  if (inverse.w > 0.0) {
    fine = times(Sym3(inverse.xyz, FETCH(block_inverse, 2u * i + 1u).xyz), FETCH(gradient, i).xyz);
#if COARSE
    uint end = FETCH1(coarse_row_begin, i + 1u);
    for (uint k = FETCH1(coarse_row_begin, i); k < end; ++k) {
      uvec4 entries = FETCH(coarse_rows, k);
      coarse += uintBitsToFloat(entries.y) * FETCH(coarse_correction, entries.x).xyz;
      coarse += uintBitsToFloat(entries.w) * FETCH(coarse_correction, entries.z).xyz;
    }
#endif
  }
}

#if SWEEP
void main() {
  ITEM_OR_RETURN(i)
  vec3 fine, coarse;
  correct(i, fine, coarse);
  vec3 u = FETCH(displacement, i).xyz;
  iterate[i] = vec4(u, 0.0);
  STORE3(fine_direction[i], u - RELAXATION * (fine + coarse))
  STORE3(coarse_direction[i], fine + coarse)
}
#else
void main() {
  LANE_OR_RETURN(i)
  SubspaceSums sums = SubspaceSums(vec4(0.0), vec4(0.0), vec4(0.0));
  FOR_ITEMS_OF_LANE(k, i, invocations, vertex_count) {
    uint v = LISTED_ITEM(k);
    vec3 fine, coarse;
    correct(v, fine, coarse);
#if SPLIT
    STORE3(fine_direction[v], fine)
    STORE3(coarse_direction[v], coarse)
#else
    fine += coarse;
    coarse = vec3(0.0);
    STORE3(fine_direction[v], fine)
#endif
    add_vertex(sums, v, fine, coarse);
  }
  store_sums(sums, i);
}
#endif
