// Keeps the objective of objective_sum's partials: the one before the step p of guess_begin. For kernels that have declared
// `dot_partials`.
#include "sim/two_level/slice_sum.glsl"
#include "sim/two_level/subspace_state.glsl"
OUTPUT(float, SubspaceState, subspace_state)

// Called by all invocations of a work group.
void keep_objective(uint lane) {
  if (lane < SLICES) sum_slice(lane, 1u, 0u, partials);
  barrier();
  if (lane == 0u) subspace_state[SUBSPACE_OBJECTIVE] = sum_of_slices(0u, 1u).w;
}
