// Adds the impulse of contact to that of the tets around each vertex, so that the residual includes it. After
// diagnose_tet, before diagnose_vertex.
#include "common/io.glsl"
#include "common/step.glsl"
COMPUTE_1D
INPUT_UINT(ContactBegin, contact_begin)      // [vertex_count + 1]
INPUT_UINT(ContactEnd, contact_end)          // [vertex_count]
INPUT_UINT(ContactEntries, contact_entries)  // 4 * point + corner
INPUT_VEC4(ContactWeights, contact_weights)  // [points]
INPUT_VEC4(ContactForce, contact_force)      // [points] [N]
INPUT_UINT(SlotBegin, slot_begin)            // [vertex_count + 1]
INOUT(vec4, Correction, correction)          // [slots] h^2 times the force of each corner

void main() {
  ITEM_OR_RETURN(v)
  uint slot = FETCH1(slot_begin, v), begin = FETCH1(contact_begin, v), end = FETCH1(contact_end, v);
  if (slot == FETCH1(slot_begin, v + 1u) || begin == end) return;
  vec3 force = vec3(0.0);
  for (uint k = begin; k < end; ++k) {
    uint entry = FETCH1(contact_entries, k);
    force += FETCH(contact_weights, entry / 4u)[entry % 4u] * FETCH(contact_force, entry / 4u).xyz;
  }
  correction[slot].xyz += SUBSTEP * SUBSTEP * force;
}
