// Applies the step p of guess_begin, after the objective and its gradient before it are known. After gradient.
#include "common/io.glsl"
COMPUTE_1D
INPUT_VEC4(Gradient, gradient)                     // [vertex_count] g at u_n [kg m]
INPUT_VEC4(LastStep, last_step)                    // [vertex_count] p [m]
OUTPUT(vec4, PreviousGradient, previous_gradient)  // [vertex_count]
INPUT_VEC4_IN_PLACE(Iterate, iterate)              // [vertex_count] u [m]
OUTPUT(vec4, Displacement, displacement)

void main() {
  ITEM_OR_RETURN(i)
  STORE3(previous_gradient[i], FETCH(gradient, i).xyz)
  displacement[i].xyz = FETCH_IN_PLACE(iterate, i).xyz + FETCH(last_step, i).xyz;
}
