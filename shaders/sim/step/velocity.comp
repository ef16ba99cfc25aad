// v = (u - u*) / l as v* + l g + (u - u~) / l: u* and u~ are rounded to the digits of u, beside which l^2 g may be nothing in
// short steps, while u - u~ is what the forces of the stage moved the vertex by. Last pass of a stage
// (sim/integrators/stage.h). Records a vertex that is not finite, or that the forces have thrown implausibly far from its
// prediction: the state has diverged.
#include "common/io.glsl"
#include "common/finite.glsl"
#include "common/step.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)                   // [vertex_count] u [m]
INPUT_VEC4(PreviousDisplacement, previous_displacement)  // [vertex_count] u* [m]
INPUT_VEC4(Predicted, predicted)                         // [vertex_count] xyz u~ [m], w inverse mass, 0 where
                                                         // constrained
INPUT_VEC4_IN_PLACE(VelocityBefore, velocity_before)     // [vertex_count] v at the start of the stage [m/s]
OUTPUT(vec4, Velocity, velocity)                         // [vertex_count] [m/s]
#ifdef EXTRAPOLATES
INOUT(vec4, EarlierVelocity, earlier_velocity)           // [vertex_count] v at the start of the stage or substep before;
                                                         // this stage's own at the end of this pass
#endif
INOUT(uint, Diverged, diverged)                          // [1] smallest index of such a vertex so far

void main() {
  ITEM_OR_RETURN(i)
  vec3 u = FETCH(displacement, i).xyz, before = FETCH_IN_PLACE(velocity_before, i).xyz, inertial = before;
#ifdef EXTRAPOLATES
  inertial += EXTRAPOLATION * (before - earlier_velocity[i].xyz);
  earlier_velocity[i] = vec4(before, 0.0);
#endif
  vec4 predicted_i = FETCH(predicted, i);
  bool moves = predicted_i.w > 0.0;
  STORE3(velocity[i], moves ? inertial + (SUBSTEP * GRAVITY + (u - predicted_i.xyz) / SUBSTEP)
                            : (u - FETCH(previous_displacement, i).xyz) / SUBSTEP)
  float thrown = distance(u, predicted_i.xyz);
  if (moves && (thrown >= FARTHEST || !is_finite(thrown))) atomicMin(diverged[0], i);
}
