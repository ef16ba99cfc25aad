// Adds the impulse of contact to that of the tets around each free vertex, so that the residual includes it. After
// diagnose_tet, before diagnose_vertex.
#include "common/io.glsl"
#include "common/step.glsl"
COMPUTE_1D
#include "sim/contact/entry.glsl"
INPUT_VEC4(ContactForce, contact_force)      // [points] [N]
INPUT_VEC4(RestPosition, rest_position)      // [vertex_count] w inverse mass, 0 if held
INPUT_UINT(SlotBegin, slot_begin)            // [vertex_count + 1]
INOUT(vec4, Correction, correction)          // [slots] h^2 times the force of each corner

#define ADD_FORCE(point, weight, first) force += (weight) * FETCH(contact_force, point).xyz;

void main() {
  ITEM_OR_RETURN(v)
  uint slot = FETCH1(slot_begin, v);
  if (FETCH(rest_position, v).w == 0.0 || slot == FETCH1(slot_begin, v + 1u) || FETCH1(contact_begin, v) == FETCH1(contact_end, v)) return;
  vec3 force = vec3(0.0);
  FOR_POINTS_AROUND(v, ADD_FORCE)
  correction[slot].xyz += SUBSTEP * SUBSTEP * force;
}
