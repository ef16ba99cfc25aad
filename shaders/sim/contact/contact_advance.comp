// Moves the bodies along the first step, or along their way as a whole if they are carried (support.glsl), to where they
// meet something. The first step of those that are carried loses what gravity adds to it, which would lead them into what
// carries them. With fewer than four iterations it keeps that, so that these go back: what they leave of a vibration would
// else not die away, and bodies at rest would tremble. Where the whole step raises the objective, the iterations so go
// back to there, and not to the start of the stage. After guess_begin.
#include "common/io.glsl"
COMPUTE_1D
#include "common/step.glsl"
#include "sim/contact/support.glsl"
INPUT_UINT(ContactBodies, contact_bodies)  // support.glsl
INPUT_UINT(ContactBody, contact_body)      // [2 * vertex_count] whose share limits it, NO_BODY where constrained; its own
INPUT_VEC4_IN_PLACE(Iterate, iterate)      // [vertex_count] u at the start of the stage [m]
OUTPUT(vec4, Displacement, displacement)
INOUT(vec4, LastStep, last_step)           // [vertex_count] p [m]
uniform uint bodies;
#define NO_BODY 0xffffffffu
#define BODY_WORD(word) FETCH1(contact_bodies, word)

void main() {
  ITEM_OR_RETURN(i)
  uint leader = FETCH1(contact_body, 2u * i);
  if (leader == NO_BODY) return;
  float share = uintBitsToFloat(FETCH1(contact_bodies, leader));
  uint force = FORCE_OF_BODY(FETCH1(contact_body, 2u * i + 1u));
  bool carried = IS_CARRIED(force);
  if (!carried && (share == 0.0 || share >= 1.0)) return;
  vec3 step = last_step[i].xyz, free = step;
  if (carried) {
    if (ITERATIONS >= 4.0) step -= SUBSTEP * SUBSTEP * GRAVITY;
    free = WAY_OF_CARRIED(force);
  }
  free *= min(share, 1.0);
  displacement[i].xyz = FETCH_IN_PLACE(iterate, i).xyz + free;
  last_step[i].xyz = step - free;
}
