// What an accelerated sweep proposes, as a direction to step along: z with u - z the proposal. After the acceleration's last pass.
#include "common/io.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)      // [vertex_count] u [m]
INOUT(vec4, FineDirection, fine_direction)  // [vertex_count] the proposed u to z [m]

void main() {
  ITEM_OR_RETURN(i)
  fine_direction[i] = vec4(FETCH(displacement, i).xyz - fine_direction[i].xyz, 0.0);
}
