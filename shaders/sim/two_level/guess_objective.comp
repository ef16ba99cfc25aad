// The objective before the step p of guess_begin, from objective_sum's partials; one work group.
#include "common/io.glsl"
#include "sim/two_level/subspace_state.glsl"
COMPUTE_1D
INPUT_VEC4(DotPartials, dot_partials)  // [partials]
OUTPUT(float, SubspaceState, subspace_state)
uniform uint partials;
#include "sim/two_level/slice_sum.glsl"

void main() {
  uint lane = gl_LocalInvocationID.x;
  if (lane < SLICES) sum_slice(lane, 1u, 0u, partials);
  barrier();
  if (lane == 0u) subspace_state[SUBSPACE_OBJECTIVE] = sum_of_slices(0u, 1u).w;
}
