// The iterations' start, where the velocity leads, stored as a step p from u_n like any other, so that the objective
// without it can be evaluated. Constrained vertices keep their prescribed places. After predict and prescribe.
#include "common/io.glsl"
COMPUTE_1D
INPUT_VEC4(PreviousDisplacement, previous_displacement)  // [vertex_count] u_n [m]
INPUT_VEC4(Predicted, predicted)                         // [vertex_count] w inverse mass, 0 where constrained
OUTPUT(vec4, LastStep, last_step)                        // [vertex_count] p [m]
INPUT_VEC4_IN_PLACE(Iterate, iterate)                    // [vertex_count] u [m]
OUTPUT(vec4, Displacement, displacement)

void main() {
  ITEM_OR_RETURN(i)
  vec3 before = FETCH(previous_displacement, i).xyz;
  bool moves = FETCH(predicted, i).w > 0.0;
  STORE3(last_step[i], moves ? FETCH_IN_PLACE(iterate, i).xyz - before : vec3(0.0))
  if (moves) displacement[i].xyz = before;
}
