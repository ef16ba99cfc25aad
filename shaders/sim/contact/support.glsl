// What carries a body: it hardly follows gravity within a step, and the iterations go back to where it goes on as its
// points that press did, without gravity and as a whole: what else moves in it, a tool may end in this step. Where
// tools take all of these points alike, it goes with them along the normals, and across them, too, where friction holds it
// as a whole: between plates that accelerate, iterations from where velocities alone lead cannot bring it along. So do
// bodies that tools grip, whatever gravity is. From where gravity leads, inside the ground, ten iterations would leave a
// body that is stiff for its size with several times its weight. The forces that contact had at the end of the stage
// before tell whether it is carried, and not how much: in a stiff body a start that is off by a hundredth of what gravity
// does is as bad as one without them.
//
// contact_bodies (sim/gpu/contact/body_starts.h): [bodies] as floats: the share of the first step that is free;
// [19 * bodies] as integers: the force of contact, in units of SUPPORT_UNIT weights, the sum of the ways of points that
// press, in WAY_UNIT of that of a fall within the stage, their number, the sums of what these ways lack to where tools take
// the points, along the normals and across, the friction of tools, the sum of its bounds mu N, that of the squares of
// what ways lack, in SQUARE_UNIT of that of a fall, and that of the normal forces; [bodies] as floats: masses [kg], 0 for
// bodies that start without gravity; [points] the body whose share a point limits; [points] its own body. Weights and
// falls are those of UNIT_GRAVITY. Kernels say how they read a word of it: BODY_WORD.
#define FORCE_OF_BODY(body) (bodies + 19u * (body))
#define MASS_OF_BODY(body) (20u * bodies + (body))
#define LEADER_OF_POINT(point) (21u * bodies + (point))
#define BODY_OF_POINT(point) (21u * bodies + points + (point))
#define THREE_WORDS(first) vec3(int(BODY_WORD(first)), int(BODY_WORD((first) + 1u)), int(BODY_WORD((first) + 2u)))
#define LACKING(force) (THREE_WORDS((force) + 7u) + THREE_WORDS((force) + 10u))
#define IS_ALIKE(force) is_alike(LACKING(force), BODY_WORD((force) + 6u), BODY_WORD((force) + 17u))
#define IS_CARRIED(force) \
  (is_supported(THREE_WORDS(force)) || (IS_ALIKE(force) && is_gripped(THREE_WORDS(force), BODY_WORD((force) + 18u))))
#define WAY_OF_CARRIED(force) \
  way_of_carried(THREE_WORDS((force) + 3u), BODY_WORD((force) + 6u), THREE_WORDS((force) + 7u), THREE_WORDS((force) + 10u), \
                 THREE_WORDS((force) + 13u), BODY_WORD((force) + 16u), IS_ALIKE(force))
#define SUPPORT_UNIT 3.814697265625e-6  // 2^-18
#define WAY_UNIT 1.220703125e-4         // 2^-13
#define SQUARE_UNIT 9.765625e-4         // 2^-10
#define UNIT_GRAVITY max(length(GRAVITY), 9.81)  // [m/s^2]

// Half of the force with which a slope of this body's weight would press it is enough.
bool is_supported(vec3 units) {
  vec3 force = SUPPORT_UNIT * UNIT_GRAVITY * units;  // over the mass
  float up = -dot(GRAVITY, force), gravity = length(GRAVITY), size = length(force);
  return size > 0.0 && gravity > 0.0 && up >= 0.2 * gravity * size && size * size >= 0.5 * up;
}

// Forces of tools on it that add up to less than half of them.
bool is_gripped(vec3 units, uint pressing) {
  return pressing > 0u && length(units) < 0.5 * float(pressing);
}

// Whether tools take all of the points that press alike.
bool is_alike(vec3 lacking, uint count, uint squares) {
  lacking *= WAY_UNIT;
  return dot(lacking, lacking) >= 0.8 * float(count) * SQUARE_UNIT * float(squares);
}

// The way of a body that is carried [m]: with the tools if these take all of its points alike.
vec3 way_of_carried(vec3 ways, uint count, vec3 along, vec3 across, vec3 friction, uint bound, bool alike) {
  if (alike) ways += length(friction) < 0.98 * float(bound) ? along + across : along;
  return ways * (WAY_UNIT * STAGE_DURATION * STAGE_DURATION * UNIT_GRAVITY / float(max(count, 1u)));
}

// How deep inside a piece the iterations may start, so that a point with this penalty [N/m] presses [m]: `most`, but no
// deeper than where it alone takes up a part of what stops the body on its `way` within the stage [m], or of its weight.
float least_depth(float most, float penalty, float mass, float way) {
  const float part = 0.3;  // of some ten points that touch
  float inertia = mass * max(way / (SUBSTEP * SUBSTEP), length(GRAVITY));
  return mass > 0.0 ? min(most, part * inertia / penalty) : most;
}
