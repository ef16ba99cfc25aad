// Anderson acceleration, last pass: x_{k+1} = G(x_k) - sum_j theta_j dG_j.
#include "common/io.glsl"
#include "sim/anderson_state.glsl"
COMPUTE_1D
INPUT_FLOAT(AndersonState, anderson_state)
INPUT_VEC4(Image, image)                // [vertex_count] G(x_k) [m]
INPUT_VEC4(ImageChange, image_change)   // [window * vertex_count] dG
OUTPUT(vec4, Iterate, iterate)          // [vertex_count] x_{k+1}
OUTPUT(vec4, Displacement, displacement)  // [vertex_count] x_{k+1}; w stays

void main() {
  ITEM_OR_RETURN(i)
  vec3 x = FETCH(image, i).xyz;
  uint count = uint(FETCH1(anderson_state, ANDERSON_COUNT));
  for (uint j = 0u; j < count; ++j)
    x -= FETCH1(anderson_state, ANDERSON_WEIGHTS + j) * FETCH(image_change, j * invocations + i).xyz;
  iterate[i] = vec4(x, 0.0);
  displacement[i].xyz = x;
}
