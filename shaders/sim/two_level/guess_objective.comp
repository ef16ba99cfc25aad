// The objective before the step p of guess_begin, one work group. After objective_sum; with LAST_GROUP its last work group
// does this.
#include "common/io.glsl"
COMPUTE_1D
INPUT_VEC4(DotPartials, dot_partials)  // [partials]
uniform uint partials;
#include "sim/two_level/objective_before.glsl"

void main() { keep_objective(gl_LocalInvocationID.x); }
