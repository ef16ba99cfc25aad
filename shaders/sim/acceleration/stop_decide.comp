// Ends the iterations of a substep once the relative residual (Diagnostics::residual) is at most the tolerance: the
// remaining passes get no work groups, so nothing is read back. One work group, before an iteration. After
// stop_residual.
#include "common/io.glsl"
#include "common/finite.glsl"
#include "common/step.glsl"
COMPUTE_1D
INPUT_VEC4(ResidualPartials, residual_partials)  // [2 * partials]
INPUT_UINT(FullGroups, full_groups)              // [pass_count] work groups of every pass
OUTPUT(uint, DispatchArguments, dispatch_arguments)  // [3 * pass_count]
INOUT(uint, StopState, stop_state)               // iterations of this substep, and of all substeps so far
uniform uint partials, pass_count, interval;     // interval: iterations from one check to the next

shared bool stopped;

void main() {
  if (gl_LocalInvocationID.x == 0u) {
    vec4 sum = vec4(0.0);
    float motion = 0.0;
    for (uint k = 0u; k < partials; ++k) {
      sum += FETCH(residual_partials, k);
      motion += FETCH(residual_partials, partials + k).x;
    }
    float scale = sqrt(sum.y) + sqrt(sum.z) + sqrt(sum.w);
    float rounding = 1e-6 * SUBSTEP * sqrt(motion);  // ten float32 roundings of M (u - u_n)
    // False if a sum is not a number or has overflowed.
    stopped = is_finite(sum.x) && (scale <= rounding || sqrt(sum.x) <= TOLERANCE * scale);
#if FIRST_ITERATION
    uint done = 0u;
#else
    uint done = stop_state[0];
#endif
    uint next = stopped ? 0u : min(interval, uint(ITERATIONS) - done);
    stop_state[0] = done + next;
    stop_state[1] += next;
  }
  barrier();
  for (uint k = gl_LocalInvocationID.x; k < pass_count; k += GROUP_SIZE) dispatch_arguments[3u * k] = stopped ? 0u : FETCH1(full_groups, k);
}
