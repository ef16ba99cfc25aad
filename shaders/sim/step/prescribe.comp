// Puts prescribed vertices at the place that their motion has at the end of this substep. After predict, before the
// iterations.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(PrescribedVertex, prescribed_vertex)  // [prescribed_count]
INPUT_VEC4(PrescribedTarget, prescribed_target)  // [prescribed_count] displacement [m]
OUTPUT(vec4, Displacement, displacement)

void main() {
  ITEM_OR_RETURN(i)
  displacement[FETCH1(prescribed_vertex, i)] = vec4(FETCH(prescribed_target, i).xyz, 0.0);
}
