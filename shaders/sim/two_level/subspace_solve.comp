// The step of the subspace from partial sums that kernels before it have stored, one work group. After two_level_correct or
// subspace_dots, and subspace_curvature; before subspace_update. With LAST_GROUP those kernels' last work groups do this.
#include "common/io.glsl"
COMPUTE_1D
INPUT_VEC4(DotPartials, dot_partials)
uniform uint partials;
#include "sim/two_level/subspace_step.glsl"

void main() { solve_subspace_step(gl_LocalInvocationID.x); }
