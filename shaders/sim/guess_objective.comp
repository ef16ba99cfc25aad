// The objective before the step p of guess_begin, from objective_sum's partials; one work group.
#include "common/io.glsl"
#include "common/group_sum.glsl"
#include "sim/subspace_state.glsl"
COMPUTE_1D
INPUT_VEC4(DotPartials, dot_partials)  // [partials]
OUTPUT(float, SubspaceState, subspace_state)
uniform uint partials;

void main() {
  uint lane = gl_LocalInvocationID.x;
  vec3 sum = vec3(0.0);
  if (lane < LANES)
    for (uint k = lane; k < partials; k += LANES) sum.x += FETCH(dot_partials, k).w;
  SUM_OVER_LANES(sum, lane)
  if (lane == 0u) subspace_state[SUBSPACE_OBJECTIVE] = sum.x;
}
