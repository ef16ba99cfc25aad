// Chebyshev acceleration on positions (Wang 2015), first of three passes: |f|^2 of the residual f = G(x_k) - x_k of the
// method's sweep. After the sweep; before chebyshev_weight.
#include "common/io.glsl"
#include "common/reduce.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)     // [vertex_count] G(x_k) [m]
INPUT_VEC4(Start, start)                   // [vertex_count] x_k [m]
OUTPUT(vec4, SquarePartials, square_partials)  // [partials] x: sums of |f|^2 [m^2]
uniform uint vertex_count;

void main() {
  ITEM_OR_RETURN(i)
  vec4 sum = vec4(0.0);
  FOR_ITEMS_OF_LANE(v, i, invocations, vertex_count) {
    vec3 f = FETCH(displacement, v).xyz - FETCH(start, v).xyz;
    sum.x += dot(f, f);
  }
  STORE_PARTIAL(square_partials, i, sum)
}
