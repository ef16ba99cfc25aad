// The result of an accelerated sweep as a direction z to step along: u - z is the result. After the acceleration's last
// pass.
#include "common/io.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)      // [vertex_count] u [m]
INPUT_VEC4_IN_PLACE(Proposed, proposed)      // [vertex_count] u [m]
OUTPUT(vec4, FineDirection, fine_direction)  // [vertex_count] z [m]

void main() {
  ITEM_OR_RETURN(i)
  STORE3(fine_direction[i], FETCH(displacement, i).xyz - FETCH_IN_PLACE(proposed, i).xyz)
}
