// The step of subspace_step.glsl at a vertex. Several kernels compute it; `precise` gives all of them the same bits.
#include "sim/two_level/subspace_state.glsl"
INPUT_FLOAT(SubspaceState, subspace_state)
INPUT_VEC4(FineDirection, fine_direction)  // [vertex_count] z_f [m]
#if SPLIT
INPUT_VEC4(CoarseDirection, coarse_direction)  // [vertex_count] z_c [m]
#endif

// `factors`: SUBSPACE_STEP or SUBSPACE_LAST_STEP; `p`: the last step [m].
vec3 along_span(uint factors, uint v, vec3 p) {
  precise vec3 sum = FETCH1(subspace_state, factors + 2u) * p + FETCH1(subspace_state, factors) * FETCH(fine_direction, v).xyz;
#if SPLIT
  float coarse = FETCH1(subspace_state, factors + 1u);  // 0 where the coarse direction is no number
  if (coarse != 0.0) sum += coarse * FETCH(coarse_direction, v).xyz;
#endif
  return sum;
}

vec3 moved(vec3 u, uint v, vec3 p) {
  precise vec3 sum = u + along_span(SUBSPACE_STEP, v, p);
  return sum;
}
