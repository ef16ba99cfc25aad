// Anderson acceleration on positions (Peng et al. 2018, section 3), first of four passes: the residual f_k = G(x_k) - x_k of the
// method's sweep, and the newest columns of the histories, dF = f_k - f_{k-1} and dG = G(x_k) - G(x_{k-1}).
// After the sweep; before anderson_dots.
#include "common/io.glsl"
#include "sim/anderson_state.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)         // [vertex_count] G(x_k) [m]
INPUT_VEC4(Iterate, iterate)                   // [vertex_count] x_k [m]
INPUT_FLOAT(AndersonState, anderson_state)
INOUT(vec4, Residual, residual)                // [vertex_count] f_{k-1} to f_k
INOUT(vec4, Image, image)                      // [vertex_count] G(x_{k-1}) to G(x_k)
OUTPUT(vec4, ResidualChange, residual_change)  // [window * vertex_count] dF
OUTPUT(vec4, ImageChange, image_change)        // [window * vertex_count] dG

void main() {
  ITEM_OR_RETURN(i)
  vec3 g = FETCH(displacement, i).xyz;
  vec3 f = g - FETCH(iterate, i).xyz;
  uint column = uint(FETCH1(anderson_state, ANDERSON_NEXT)) * invocations + i;
  residual_change[column] = vec4(f - residual[i].xyz, 0.0);
  image_change[column] = vec4(g - image[i].xyz, 0.0);
  residual[i] = vec4(f, 0.0);
  image[i] = vec4(g, 0.0);
}
