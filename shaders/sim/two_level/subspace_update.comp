// Applies the step of subspace_solve, unless the next gradient does (sim/elasticity/feature_step.glsl).
#include "common/io.glsl"
#include "sim/two_level/subspace_state.glsl"
COMPUTE_1D
#if FINAL
INPUT_FLOAT(SubspaceState, subspace_state)
#else
#include "sim/two_level/subspace_move.glsl"
INPUT_VEC4(Gradient, gradient)                   // [vertex_count] g [kg m]
OUTPUT(vec4, PreviousGradient, previous_gradient)  // [vertex_count] g before the new p
OUTPUT(vec4, LastStep, last_step)                  // [vertex_count] the new p
#endif
INPUT_VEC4_IN_PLACE(StepBefore, step_before)  // [vertex_count] p [m]
INPUT_VEC4_IN_PLACE(Iterate, iterate)         // [vertex_count] u [m]
OUTPUT(vec4, Displacement, displacement)
#if COMPENSATED
INPUT_VEC4_IN_PLACE(IterateLow, iterate_low)  // [vertex_count] the part of u that float32 cannot represent [m]
OUTPUT(vec4, DisplacementLow, displacement_low)
#endif

void main() {
  ITEM_OR_RETURN(i)
  vec3 p = FETCH_IN_PLACE(step_before, i).xyz;
#if FINAL
  vec3 step = FETCH1(subspace_state, SUBSPACE_STEP + 2u) * p;
#else
  vec3 step = along_span(SUBSPACE_STEP, i, p);
  STORE3(last_step[i], along_span(SUBSPACE_LAST_STEP, i, p))
  if (FETCH1(subspace_state, SUBSPACE_ACCEPTED) > 0.5) STORE3(previous_gradient[i], FETCH(gradient, i).xyz)
#endif
#if COMPENSATED
  // Knuth's two-sum; `precise` keeps compilers from simplifying the rounding away.
  vec3 u = FETCH_IN_PLACE(iterate, i).xyz, low = FETCH_IN_PLACE(iterate_low, i).xyz + step;
  precise vec3 sum = u + low, added = sum - u;
  precise vec3 lost = (u - (sum - added)) + (low - added);
  displacement[i].xyz = sum;
  STORE3(displacement_low[i], lost)
#else
  precise vec3 sum = FETCH_IN_PLACE(iterate, i).xyz + step;
  displacement[i].xyz = sum;
#endif
}
