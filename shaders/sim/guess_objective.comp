// The objective before the step p of guess_begin, from objective_sum's partials; one work group.
#include "common/io.glsl"
#include "sim/subspace_state.glsl"
COMPUTE_1D
INPUT_VEC4(DotPartials, dot_partials)  // [partials]
OUTPUT(float, SubspaceState, subspace_state)
uniform uint partials;

void main() {
  if (gl_GlobalInvocationID.x != 0u) return;
  float sum = 0.0;
  for (uint k = 0u; k < partials; ++k) sum += FETCH(dot_partials, k).w;
  subspace_state[SUBSPACE_OBJECTIVE] = sum;
}
