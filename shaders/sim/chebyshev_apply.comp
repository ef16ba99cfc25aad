// Chebyshev acceleration, last pass: x_{k+1} = omega (G(x_k) - x_{k-1}) + x_{k-1} (Wang 2015, eq. 9, without relaxation).
#include "common/io.glsl"
#include "sim/chebyshev_state.glsl"
COMPUTE_1D
#if FIRST_ITERATION
INPUT_VEC4(Start, start)                // [vertex_count] x_0 [m]
INPUT_VEC4(Displacement, displacement)  // [vertex_count] G(x_0), which is x_1
OUTPUT(vec4, Iterate, iterate)          // [vertex_count] x_1
OUTPUT(vec4, Before, before)            // [vertex_count] x_0
#else
INPUT_FLOAT(ChebyshevState, chebyshev_state)
INOUT(vec4, Displacement, displacement)  // [vertex_count] G(x_k) to x_{k+1}; w stays
INOUT(vec4, Iterate, iterate)            // [vertex_count] x_k to x_{k+1}
INOUT(vec4, Before, before)              // [vertex_count] x_{k-1} to x_k
#endif

void main() {
  ITEM_OR_RETURN(i)
#if FIRST_ITERATION
  before[i] = FETCH(start, i);
  iterate[i] = FETCH(displacement, i);
#else
  float omega = FETCH1(chebyshev_state, CHEBYSHEV_WEIGHT);
  vec3 x = displacement[i].xyz;
  // Written so that omega = 1 changes no bit.
  if (omega != 1.0) x = omega * (x - before[i].xyz) + before[i].xyz;
  displacement[i].xyz = x;
  before[i] = iterate[i];
  iterate[i] = vec4(x, 0.0);
#endif
}
