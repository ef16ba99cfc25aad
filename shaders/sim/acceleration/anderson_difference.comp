// Anderson acceleration (Walker and Ni 2011, algorithm AA), first of four passes: the residual f_k = G(z_k) - z_k of
// the method's sweep, and the newest columns of the histories, dF = f_k - f_{k-1} and dG = G(z_k) - G(z_{k-1}).
// After the sweep; before anderson_dots.
#include "common/io.glsl"
#include "sim/acceleration/anderson_state.glsl"
COMPUTE_1D
INPUT_VEC4(Value, value)      // [invocations] G(z_k)
INPUT_VEC4(Iterate, iterate)  // [invocations] z_k
#include "sim/acceleration/feature_weight.glsl"
INPUT_FLOAT(AndersonState, anderson_state)
INPUT_VEC4_IN_PLACE(ResidualBefore, residual_before)  // [invocations] xyz f_{k-1}, w weight
INPUT_VEC4_IN_PLACE(ImageBefore, image_before)        // [invocations] G(z_{k-1})
OUTPUT(vec4, Residual, residual)               // [invocations] xyz f_k, w weight
OUTPUT(vec4, Image, image)                     // [invocations] G(z_k)
OUTPUT(vec4, ResidualChange, residual_change)  // [window * invocations] dF
OUTPUT(vec4, ImageChange, image_change)        // [window * invocations] dG

void main() {
  ITEM_OR_RETURN(i)
  vec3 g = FETCH(value, i).xyz;
  vec3 f = g - FETCH(iterate, i).xyz;
  uint column = uint(FETCH1(anderson_state, ANDERSON_NEXT)) * invocations + i;
  STORE3(residual_change[column], f - FETCH_IN_PLACE(residual_before, i).xyz)
  STORE3(image_change[column], g - FETCH_IN_PLACE(image_before, i).xyz)
  residual[i] = vec4(f, weight_of(i));
  STORE3(image[i], g)
}
