// Adds the springs' impulse to that of the tets around each grabbed vertex, so that the residual includes it.
// After diagnose_tet, before diagnose_vertex. A vertex with only fixed tets has no slots, and no residual.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(GrabVertex, grab_vertex)          // [grab_count]
INPUT_VEC4(GrabMultiplier, grab_multiplier)  // [grab_count] h^2 times the force on the tissue [kg m]
INPUT_UINT(SlotBegin, slot_begin)            // [vertex_count + 1]
INOUT(vec4, Correction, correction)          // [slots] h^2 times the force of each corner

void main() {
  ITEM_OR_RETURN(i)
  uint vertex = FETCH1(grab_vertex, i), slot = FETCH1(slot_begin, vertex);
  if (slot < FETCH1(slot_begin, vertex + 1u)) correction[slot].xyz += FETCH(grab_multiplier, i).xyz;
}
