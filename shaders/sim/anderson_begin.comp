// Anderson acceleration on positions, the only pass of a substep's first iteration: x_1 = G(x_0) is the plain one, the history is empty.
#include "common/io.glsl"
#include "sim/anderson_state.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] G(x_0) [m]
INPUT_VEC4(Start, start)                // [vertex_count] x_0 [m]
OUTPUT(vec4, Iterate, iterate)          // [vertex_count] x_1
OUTPUT(vec4, Residual, residual)        // [vertex_count] f_0 = G(x_0) - x_0
OUTPUT(vec4, Image, image)              // [vertex_count] G(x_0)
OUTPUT(float, AndersonState, anderson_state)

void main() {
  ITEM_OR_RETURN(i)
  vec3 g = FETCH(displacement, i).xyz;
  iterate[i] = vec4(g, 0.0);
  residual[i] = vec4(g - FETCH(start, i).xyz, 0.0);
  image[i] = vec4(g, 0.0);
  if (i == 0u) {
    anderson_state[ANDERSON_NEXT] = 0.0;
    anderson_state[ANDERSON_COUNT] = 0.0;
    anderson_state[ANDERSON_SQUARED] = 3.4e38;
  }
}
