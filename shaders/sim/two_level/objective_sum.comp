// Sums the objective of the step over the vertices, into the w of the partials that subspace_solve reads. After gradient.
// Before the first step, which is not FINAL, it then applies the step p of guess_begin, to which objective and gradient
// are now known. With LAST_GROUP the last work group also does the work of guess_objective or, with FINAL, of subspace_solve.
#include "common/io.glsl"
#include "common/reduce.glsl"
COMPUTE_1D
INPUT_VEC4(Gradient, gradient)  // [vertex_count] xyz g [kg m], w objective [kg m^2]
#if !FINAL
INPUT_VEC4(LastStep, last_step)                    // [vertex_count] p [m]
OUTPUT(vec4, PreviousGradient, previous_gradient)  // [vertex_count] g at u_n [kg m]
INPUT_VEC4_IN_PLACE(Iterate, iterate)              // [vertex_count] u [m]
OUTPUT(vec4, Displacement, displacement)
#endif
uniform uint vertex_count;
#ifdef LAST_GROUP
COHERENT(vec4, DotPartials, dot_partials)
uniform uint partials;
#include "common/last_group.glsl"
#include "sim/two_level/slice_sum.glsl"
#include "sim/two_level/subspace_state.glsl"
#if FINAL
#include "sim/two_level/subspace_step.glsl"
#else
#include "sim/two_level/objective_before.glsl"
#endif
#else
OUTPUT(vec4, DotPartials, dot_partials)
#endif

void main() {
  LANE_OR_RETURN(i)
  float sum = 0.0;
  FOR_ITEMS_OF_LANE(k, i, invocations, vertex_count) {
    uint v = LISTED_ITEM(k);
    vec4 g = FETCH(gradient, v);
    sum += g.w;
#if !FINAL
    STORE3(previous_gradient[v], g.xyz)
    displacement[v].xyz = FETCH_IN_PLACE(iterate, v).xyz + FETCH(last_step, v).xyz;
#endif
  }
  STORE_PARTIAL(dot_partials, i, vec4(0.0, 0.0, 0.0, sum))
#ifdef LAST_GROUP
  if (!is_last_group()) return;
#if FINAL
  solve_subspace_step(gl_LocalInvocationID.x);
#else
  keep_objective(gl_LocalInvocationID.x);
#endif
#endif
}
