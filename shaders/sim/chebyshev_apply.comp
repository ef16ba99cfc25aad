// Chebyshev acceleration on positions, last pass: x_{k+1} = omega (G(x_k) - x_{k-1}) + x_{k-1} (Wang 2015, eq. 9, without relaxation).
#include "common/io.glsl"
#include "sim/chebyshev_state.glsl"
COMPUTE_1D
INPUT_FLOAT(ChebyshevState, chebyshev_state)
INOUT(vec4, Displacement, displacement)  // [vertex_count] G(x_k) to x_{k+1} [m]; w stays
INOUT(vec4, Iterate, iterate)            // [vertex_count] x_k to x_{k+1}
INOUT(vec4, Before, before)              // [vertex_count] x_{k-1} to x_k

void main() {
  ITEM_OR_RETURN(i)
  float omega = FETCH1(chebyshev_state, CHEBYSHEV_WEIGHT);
  vec3 x = displacement[i].xyz;
  if (omega != 1.0) x = omega * (x - before[i].xyz) + before[i].xyz;  // a weight of 1 changes no bit
  displacement[i].xyz = x;
  before[i] = iterate[i];
  iterate[i] = vec4(x, 0.0);
}
