// Takes the start of the iterations back to where the body of a vertex meets something: beyond, it would have to be left
// again. After contact_start.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(ContactLimit, contact_limit)                // [bodies] as floats: the share of the way that is free, 0: as it is
INPUT_UINT(ContactBody, contact_body)                  // [vertex_count] NO_BODY where constrained
INPUT_VEC4(StartDisplacement, start_displacement)      // [vertex_count] u at the start [m]
INPUT_VEC4_IN_PLACE(Iterate, iterate)                  // [vertex_count] u where the iterations start [m]
OUTPUT(vec4, Displacement, displacement)
#define NO_BODY 0xffffffffu

void main() {
  ITEM_OR_RETURN(i)
  uint body = FETCH1(contact_body, i);
  if (body == NO_BODY) return;
  float share = uintBitsToFloat(FETCH1(contact_limit, body));
  if (share == 0.0 || share >= 1.0) return;
  vec3 from = FETCH(start_displacement, i).xyz;
  displacement[i].xyz = from + share * (FETCH_IN_PLACE(iterate, i).xyz - from);
}
