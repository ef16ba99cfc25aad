// What carries a body: it hardly follows gravity within a step, and the iterations go back to where it goes on as its
// points that press did, without gravity and as a whole: what else moves in it, a tool may end in this step. Along the
// normals they go with the tool, and across them, too, where friction holds the body as a whole: between plates that
// accelerate, iterations from where velocities alone lead cannot bring it along. From where gravity leads, inside the ground, ten iterations would leave a body that is stiff for its size with
// several times its weight. The forces that contact had at the end of the stage before tell whether it is carried, and
// not how much: in a stiff body a start that is off by a hundredth of what gravity does is as bad as one without them.
//
// contact_bodies (sim/gpu/contact/body_starts.h): [bodies] as floats: the share of the first step that is free;
// [14 * bodies] as integers: the force of contact, in units of SUPPORT_UNIT weights, the sum of the ways of points that
// press, in WAY_UNIT of that of a fall within the stage, their number, the sum of the ways from there to where tools take
// these points, the friction of tools and the sum of its bounds mu N; [bodies] as floats: masses [kg], 0 for bodies that
// start without gravity; [points] the body whose share a point limits; [points] its own body. Kernels say how they read a
// word of it: BODY_WORD.
#define FORCE_OF_BODY(body) (bodies + 14u * (body))
#define MASS_OF_BODY(body) (15u * bodies + (body))
#define LEADER_OF_POINT(point) (16u * bodies + (point))
#define BODY_OF_POINT(point) (16u * bodies + points + (point))
#define THREE_WORDS(first) vec3(int(BODY_WORD(first)), int(BODY_WORD((first) + 1u)), int(BODY_WORD((first) + 2u)))
#define IS_CARRIED(force) is_carried(THREE_WORDS(force))
#define WAY_OF_CARRIED(force) \
  way_of_carried(THREE_WORDS((force) + 3u), BODY_WORD((force) + 6u), THREE_WORDS((force) + 7u), THREE_WORDS((force) + 10u), \
                 BODY_WORD((force) + 13u))
#define SUPPORT_UNIT 3.814697265625e-6  // 2^-18
#define WAY_UNIT 1.220703125e-4         // 2^-13

// Half of the force with which a slope of this body's weight would press it is enough.
bool is_carried(vec3 units) {
  vec3 force = SUPPORT_UNIT * units;
  float up = -dot(GRAVITY, force), gravity = length(GRAVITY), size = length(force);
  return size > 0.0 && up >= 0.2 * gravity * size && gravity * size * size >= 0.5 * up;
}

// The way of a body that is carried [m].
vec3 way_of_carried(vec3 ways, uint count, vec3 to_tools, vec3 friction, uint bound) {
  vec3 all = length(friction) < 0.98 * float(bound) ? ways + to_tools : ways;
  return all * (WAY_UNIT * STAGE_DURATION * STAGE_DURATION * length(GRAVITY) / float(max(count, 1u)));
}

// How deep inside a piece the iterations may start, so that a point with this penalty [N/m] presses [m]: `most`, but no
// deeper than where it alone takes up a part of what stops the body on its `way` within the stage [m], or of its weight.
float least_depth(float most, float penalty, float mass, float way) {
  const float part = 0.3;  // of some ten points that touch
  float inertia = mass * max(way / (SUBSTEP * SUBSTEP), length(GRAVITY));
  return mass > 0.0 ? min(most, part * inertia / penalty) : most;
}
