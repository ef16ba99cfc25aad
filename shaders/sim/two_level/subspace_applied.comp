// Notes that subspace_update has applied the step, where the next gradient would apply it, too: it then leaves displacements,
// p and the gradient before p as they are. For a look at the state between two iterations.
#include "common/io.glsl"
#include "sim/two_level/subspace_state.glsl"
COMPUTE_1D
OUTPUT(float, SubspaceState, subspace_state)

void main() {
  ITEM_OR_RETURN(k)
  if (k < 3u) {
    subspace_state[SUBSPACE_STEP + k] = 0.0;
    subspace_state[SUBSPACE_LAST_STEP + k] = k == 2u ? 1.0 : 0.0;
  } else {
    subspace_state[SUBSPACE_ACCEPTED] = 0.0;
  }
}
