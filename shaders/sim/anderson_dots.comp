// Anderson acceleration, second pass: dot products of every column j of dF with the newest column and with f.
// After anderson_difference, before anderson_solve. Held vertices have f = 0.
#include "common/io.glsl"
#include "common/reduce.glsl"
#include "sim/anderson_state.glsl"
COMPUTE_1D
INPUT_FLOAT(AndersonState, anderson_state)
INPUT_VEC4(Residual, residual)               // [vertex_count] f_k
INPUT_VEC4(ResidualChange, residual_change)  // [window * vertex_count] dF
OUTPUT(vec4, DotPartials, dot_partials)      // x dF_new . dF_j, y dF_j . f, z f . f; those of column 0, then of column 1, ...
uniform uint vertex_count, lanes;            // lanes of one column

void main() {
  ITEM_OR_RETURN(i)
  uint column = (i / lanes) * vertex_count;
  uint newest = uint(FETCH1(anderson_state, ANDERSON_NEXT)) * vertex_count;
  vec4 sum = vec4(0.0);
  for (uint v = i % lanes; v < vertex_count; v += lanes) {
    vec3 f = FETCH(residual, v).xyz, d = FETCH(residual_change, column + v).xyz;
    sum += vec4(dot(FETCH(residual_change, newest + v).xyz, d), dot(d, f), dot(f, f), 0.0);
  }
  STORE_PARTIAL(dot_partials, i, sum)
}
