// Moves the bodies along the first step to where they meet something. Where the whole step raises the objective, the
// iterations so go back to there, and not to the start of the stage. After guess_begin.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(ContactLimit, contact_limit)  // [bodies] as floats: the share of the step that is free
INPUT_UINT(ContactBody, contact_body)    // [vertex_count] NO_BODY where constrained
INPUT_VEC4_IN_PLACE(Iterate, iterate)    // [vertex_count] u at the start of the stage [m]
OUTPUT(vec4, Displacement, displacement)
INOUT(vec4, LastStep, last_step)         // [vertex_count] p [m]
#define NO_BODY 0xffffffffu

void main() {
  ITEM_OR_RETURN(i)
  uint body = FETCH1(contact_body, i);
  if (body == NO_BODY) return;
  float share = uintBitsToFloat(FETCH1(contact_limit, body));
  if (share == 0.0 || share >= 1.0) return;
  displacement[i].xyz = FETCH_IN_PLACE(iterate, i).xyz + share * last_step[i].xyz;
  last_step[i].xyz *= 1.0 - share;
}
