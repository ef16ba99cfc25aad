// Anderson acceleration, last pass: z_{k+1} = G(z_k) - sum_j theta_j dG_j.
#include "common/io.glsl"
#include "sim/acceleration/anderson_state.glsl"
COMPUTE_1D
INPUT_FLOAT(AndersonState, anderson_state)
INPUT_VEC4(Image, image)               // [invocations] G(z_k)
INPUT_VEC4(ImageChange, image_change)  // [window * invocations] dG
OUTPUT(vec4, Iterate, iterate)         // [invocations] z_{k+1}
OUTPUT(vec4, Value, value)             // [invocations] z_{k+1}; w is kept

void main() {
  ITEM_OR_RETURN(i)
  vec3 z = FETCH(image, i).xyz;
  uint count = uint(FETCH1(anderson_state, ANDERSON_COUNT));
  for (uint j = 0u; j < count; ++j)
    z -= FETCH1(anderson_state, ANDERSON_WEIGHTS + j) * FETCH(image_change, j * invocations + i).xyz;
  STORE3(iterate[i], z)
  value[i].xyz = z;
}
