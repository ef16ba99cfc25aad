// Anderson acceleration (Walker and Ni 2011, algorithm AA), first of four passes: the residual f_k = G(z_k) - z_k of the
// method's sweep, and the newest columns of the histories, dF = f_k - f_{k-1} and dG = G(z_k) - G(z_{k-1}).
// After the sweep; before anderson_dots.
#include "common/io.glsl"
#include "sim/anderson_state.glsl"
COMPUTE_1D
INPUT_VEC4(Value, value)      // [invocations] G(z_k)
INPUT_VEC4(Iterate, iterate)  // [invocations] z_k
#include "sim/feature_weight.glsl"
INPUT_FLOAT(AndersonState, anderson_state)
INOUT(vec4, Residual, residual)                // [invocations] xyz f_{k-1} to f_k, w weight
INOUT(vec4, Image, image)                      // [invocations] G(z_{k-1}) to G(z_k)
OUTPUT(vec4, ResidualChange, residual_change)  // [window * invocations] dF
OUTPUT(vec4, ImageChange, image_change)        // [window * invocations] dG

void main() {
  ITEM_OR_RETURN(i)
  vec3 g = FETCH(value, i).xyz;
  vec3 f = g - FETCH(iterate, i).xyz;
  uint column = uint(FETCH1(anderson_state, ANDERSON_NEXT)) * invocations + i;
  residual_change[column] = vec4(f - residual[i].xyz, 0.0);
  image_change[column] = vec4(g - image[i].xyz, 0.0);
  residual[i] = vec4(f, weight_of(i));
  image[i] = vec4(g, 0.0);
}
