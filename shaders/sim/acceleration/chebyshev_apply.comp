// Chebyshev acceleration on positions, last pass: x_{k+1} = omega (G(x_k) - x_{k-1}) + x_{k-1} (Wang 2015, eq. 9,
// without relaxation).
#include "common/io.glsl"
#include "sim/acceleration/chebyshev_state.glsl"
COMPUTE_1D
INPUT_FLOAT(ChebyshevState, chebyshev_state)
INPUT_VEC4_IN_PLACE(Swept, swept)        // [vertex_count] G(x_k) [m]
INPUT_VEC4_IN_PLACE(Current, current)    // [vertex_count] x_k
INPUT_VEC4_IN_PLACE(Earlier, earlier)    // [vertex_count] x_{k-1}
OUTPUT(vec4, Displacement, displacement)  // [vertex_count] x_{k+1}; w is kept
OUTPUT(vec4, Iterate, iterate)            // [vertex_count] x_{k+1}
OUTPUT(vec4, Before, before)              // [vertex_count] x_k

void main() {
  ITEM_OR_RETURN(i)
  float omega = FETCH1(chebyshev_state, CHEBYSHEV_WEIGHT);
  vec3 x = FETCH_IN_PLACE(swept, i).xyz, x_before = FETCH_IN_PLACE(earlier, i).xyz;
  if (omega != 1.0) x = omega * (x - x_before) + x_before;  // a weight of 1 changes no bit
  displacement[i].xyz = x;
  STORE3(before[i], FETCH_IN_PLACE(current, i).xyz)
  STORE3(iterate[i], x)
}
