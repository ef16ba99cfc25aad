// Adds the springs' impulse to what the tets around each grabbed vertex do, so that the residual counts it.
// After diagnose_tet, before diagnose_vertex.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(GrabVertex, grab_vertex)          // [grab_count]
INPUT_VEC4(GrabMultiplier, grab_multiplier)  // [grab_count] h^2 times the force on the tissue [kg m]
INPUT_UINT(SlotBegin, slot_begin)            // [vertex_count + 1]
INOUT(vec4, Correction, correction)          // [4 * tet_count] h^2 times the force of each corner

void main() {
  ITEM_OR_RETURN(i)
  correction[FETCH1(slot_begin, FETCH1(grab_vertex, i))].xyz += FETCH(grab_multiplier, i).xyz;
}
