// The sums for the step of the subspace if its directions are not those of two_level_correct. After sweep_direction.
#include "common/io.glsl"
COMPUTE_1D
INPUT_VEC4(Gradient, gradient)                // [vertex_count] xyz g [kg m], w objective [kg m^2]
INPUT_VEC4(FineDirection, fine_direction)     // [vertex_count] the first direction [m]
INPUT_VEC4(CoarseDirection, coarse_direction)  // [vertex_count] the second direction [m]
#include "sim/two_level/subspace_sums.glsl"

void main() {
  LANE_OR_RETURN(i)
  SubspaceSums sums = SubspaceSums(vec4(0.0), vec4(0.0), vec4(0.0));
  FOR_ITEMS_OF_LANE(k, i, invocations, vertex_count) {
    uint v = LISTED_ITEM(k);
    add_vertex(sums, v, FETCH(fine_direction, v).xyz, FETCH(coarse_direction, v).xyz);
  }
  store_sums(sums, i);
}
