// What carries a body: it hardly follows gravity within a step, and the iterations go back to where it goes on as its
// points that press did, without gravity and as a whole: what else moves in it, a tool may end in this step. From where gravity leads, inside the ground, ten iterations would leave a body that is stiff for its size with
// several times its weight. The forces that contact had at the end of the stage before tell whether it is carried, and
// not how much: in a stiff body a start that is off by a hundredth of what gravity does is as bad as one without them.
//
// contact_bodies (sim/gpu/contact/body_starts.h): [bodies] as floats: the share of the first step that is free;
// [7 * bodies] as integers: the force of contact, in units of SUPPORT_UNIT weights, the sum of the ways of points that
// press, in WAY_UNIT of that of a fall within the stage, and their number; [bodies] as floats: masses [kg], 0 for bodies
// that start without gravity; [points] the body whose share a point limits; [points] its own body
#define FORCE_OF_BODY(body) (bodies + 7u * (body))
#define MASS_OF_BODY(body) (8u * bodies + (body))
#define LEADER_OF_POINT(point) (9u * bodies + (point))
#define BODY_OF_POINT(point) (9u * bodies + points + (point))
#define SUPPORT_UNIT 3.814697265625e-6  // 2^-18
#define WAY_UNIT 1.220703125e-4         // 2^-13

// Half of the force with which a slope of this body's weight would press it is enough.
bool is_carried(uint x, uint y, uint z) {
  vec3 force = SUPPORT_UNIT * vec3(int(x), int(y), int(z));
  float up = -dot(GRAVITY, force), gravity = length(GRAVITY), size = length(force);
  return size > 0.0 && up >= 0.2 * gravity * size && gravity * size * size >= 0.5 * up;
}

// The way of a body that is carried [m], from the sum and the number.
vec3 way_of_carried(uint x, uint y, uint z, uint count) {
  return vec3(int(x), int(y), int(z)) * (WAY_UNIT * STAGE_DURATION * STAGE_DURATION * length(GRAVITY) / float(max(count, 1u)));
}

// How deep inside a piece the iterations may start, so that a point with this penalty [N/m] presses [m]: `most`, but no
// deeper than where it alone takes up a part of what stops the body on its `way` within the stage [m], or of its weight.
float least_depth(float most, float penalty, float mass, float way) {
  const float part = 0.3;  // of some ten points that touch
  float inertia = mass * max(way / (SUBSTEP * SUBSTEP), length(GRAVITY));
  return mass > 0.0 ? min(most, part * inertia / penalty) : most;
}
