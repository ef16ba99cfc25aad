// Anderson acceleration, after the first sweep of a substep: z_1 = G(z_0) is the plain iterate, and the history is
// empty.
#include "common/io.glsl"
#include "sim/acceleration/anderson_state.glsl"
COMPUTE_1D
INPUT_VEC4(Value, value)  // [invocations] G(z_0)
#include "sim/acceleration/feature_weight.glsl"
INPUT_VEC4_IN_PLACE(Start, start)  // [invocations] z_0
OUTPUT(vec4, Iterate, iterate)     // [invocations] z_1
OUTPUT(vec4, Residual, residual)  // [invocations] xyz f_0 = G(z_0) - z_0, w weight
OUTPUT(vec4, Image, image)        // [invocations] G(z_0)
OUTPUT(float, AndersonState, anderson_state)

void main() {
  ITEM_OR_RETURN(i)
  vec3 g = FETCH(value, i).xyz;
  residual[i] = vec4(g - FETCH_IN_PLACE(start, i).xyz, weight_of(i));
  STORE3(iterate[i], g)
  STORE3(image[i], g)
  if (i == 0u) {
    anderson_state[ANDERSON_NEXT] = 0.0;
    anderson_state[ANDERSON_COUNT] = 0.0;
    anderson_state[ANDERSON_SQUARED] = 3.4e38;
  }
}
