// Chebyshev acceleration on positions, last pass of a substep's first iteration: x_1 = G(x_0) is the plain iterate.
#include "common/io.glsl"
COMPUTE_1D
INPUT_VEC4(Start, start)                // [vertex_count] x_0 [m]
INPUT_VEC4(Displacement, displacement)  // [vertex_count] G(x_0) [m]
OUTPUT(vec4, Iterate, iterate)          // [vertex_count] x_1
OUTPUT(vec4, Before, before)            // [vertex_count] x_0

void main() {
  ITEM_OR_RETURN(i)
  before[i] = FETCH(start, i);
  iterate[i] = FETCH(displacement, i);
}
