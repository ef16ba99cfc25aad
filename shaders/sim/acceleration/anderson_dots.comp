// Anderson acceleration, second pass: weighted dot products of every column j of dF with the newest column and with f.
// After anderson_difference, before anderson_solve. Constrained vertices have f = 0.
#include "common/io.glsl"
#include "common/reduce.glsl"
#include "sim/acceleration/anderson_state.glsl"
COMPUTE_1D
INPUT_FLOAT(AndersonState, anderson_state)
INPUT_VEC4(Residual, residual)               // [vector_count] xyz f_k, w weight
INPUT_VEC4(ResidualChange, residual_change)  // [window * vector_count] dF
INPUT_VEC4(Image, image)                     // [vector_count] G(z_k)
// x dF_new . dF_j, y dF_j . f, z f . f, w G . G; first those of column 0, then of column 1, ...
OUTPUT(vec4, DotPartials, dot_partials)
uniform uint vector_count, lanes;            // lanes of one column
uniform uint first_partial;

void main() {
  ITEM_OR_RETURN(i)
  uint column = (i / lanes) * vector_count;
  uint newest = uint(FETCH1(anderson_state, ANDERSON_NEXT)) * vector_count;
  vec4 sum = vec4(0.0);
  FOR_ITEMS_OF_LANE(v, i % lanes, lanes, vector_count) {
    vec4 f = FETCH(residual, v);
    vec3 d = FETCH(residual_change, column + v).xyz, g = FETCH(image, v).xyz;
    sum += f.w * vec4(dot(FETCH(residual_change, newest + v).xyz, d), dot(d, f.xyz), dot(f.xyz, f.xyz), dot(g, g));
  }
  STORE_PARTIAL(dot_partials, i + first_partial * PARTIAL_STRIDE, sum)
}
