// v = (u - u*) / l. Last pass of a stage (sim/integrators/stage.h). Records a vertex that is not finite, or that the forces have thrown
// implausibly far from its prediction: the state has diverged.
#include "common/io.glsl"
#include "common/finite.glsl"
#include "common/step.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)                   // [vertex_count] u [m]
INPUT_VEC4(PreviousDisplacement, previous_displacement)  // [vertex_count] u* [m]
INPUT_VEC4(Predicted, predicted)                         // [vertex_count] xyz u~ [m], w inverse mass, 0 where
                                                         // constrained
OUTPUT(vec4, Velocity, velocity)                         // [vertex_count] [m/s]
INOUT(uint, Diverged, diverged)                              // [1] smallest index of such a vertex so far

void main() {
  ITEM_OR_RETURN(i)
  vec3 u = FETCH(displacement, i).xyz;
  vec4 predicted_i = FETCH(predicted, i);
  STORE3(velocity[i], (u - FETCH(previous_displacement, i).xyz) / SUBSTEP)
  float thrown = distance(u, predicted_i.xyz);
  if (predicted_i.w > 0.0 && (thrown >= FARTHEST || !is_finite(thrown))) atomicMin(diverged[0], i);
}
