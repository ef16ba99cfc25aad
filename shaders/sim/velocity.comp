// v = (u - u_n) / h. Last pass of a substep.
#include "common/io.glsl"
#include "common/step.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)                   // [vertex_count] u [m]
INPUT_VEC4(PreviousDisplacement, previous_displacement)  // [vertex_count] u_n [m]
OUTPUT(vec4, Velocity, velocity)                         // [vertex_count] [m/s]

void main() {
  ITEM_OR_RETURN(i)
  velocity[i] = vec4((FETCH(displacement, i).xyz - FETCH(previous_displacement, i).xyz) / SUBSTEP, 0.0);
}
