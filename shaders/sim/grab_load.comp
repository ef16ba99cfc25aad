// Moves the prediction of grabbed vertices by their spring's impulse, so that the residual counts it as a load.
// After the iterations, before diagnose_vertex; predict overwrites the prediction in the next substep.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(GrabVertex, grab_vertex)  // [grab_count]
INPUT_VEC4(GrabMultiplier, grab_multiplier)
INOUT(vec4, Predicted, predicted)

void main() {
  ITEM_OR_RETURN(i)
  uint v = FETCH1(grab_vertex, i);
  predicted[v].xyz += predicted[v].w * FETCH(grab_multiplier, i).xyz;
}
