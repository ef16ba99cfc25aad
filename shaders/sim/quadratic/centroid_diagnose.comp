// What moves at the centroids of quadratic tets: its share of angular momentum, kinetic energy and inertia, of which
// every free vertex's slot receives its part, -M (u - u~). Supports accelerate centroids beside free vertices: the slot
// of a held one receives -h^2 times its part of mass and acceleration, since its weight is that of row sums. After
// quadratic_diagnose, before diagnose_vertex.
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/quadratic_tet.glsl"
COMPUTE_1D
INPUT_VEC4(RestPosition, rest_position)            // [vertex_count] X [m]
INPUT_VEC4(Displacement, displacement)             // [vertex_count] u [m]
INPUT_VEC4(Velocity, velocity)                     // [vertex_count] [m/s]
INPUT_VEC4(Predicted, predicted)                   // [vertex_count] w inverse mass, 0 where constrained
INPUT_VEC4(PredictedCentroid, predicted_centroid)  // [quadratic_count] xyz u~ [m], w mass [kg]
INPUT_UVEC4(QuadraticSlots, quadratic_slots)  // as in common/quadratic_slots.glsl
INOUT(vec4, Correction, correction)           // [slots] of quadratic_diagnose
OUTPUT(CentroidPartial, CentroidPartials, centroid_partials)  // [invocations]
uniform uint quadratic_count, has_step;  // has_step 0: the accelerations are unknown

vec3 displacement_of(uint v) { return FETCH(displacement, v).xyz; }
vec3 place_of(uint v) { return FETCH(rest_position, v).xyz; }
vec3 velocity_of(uint v) { return FETCH(velocity, v).xyz; }

bool is_free(uint v) { return FETCH(predicted, v).w > 0.0; }

// The part of a vertex in what moves the centroid: `share` of the inertia if it is free; else, if something moves the
// centroid, of h^2 times the force on it. Returns the share that is borne so.
float bear(uint v, uint slot, float share, vec3 inertia, bool moves, vec3 impulse) {
  if (is_free(v)) {
    correction[slot].xyz -= share * inertia;
    return share;
  }
  if (!moves || FETCH(rest_position, v).w > 0.0) return 0.0;
  correction[slot].xyz -= share * impulse;
  return share;
}

void main() {
  ITEM_OR_RETURN(lane)
  CentroidPartial partial = CentroidPartial(vec4(0.0), vec4(0.0));
  FOR_ITEMS_OF_LANE(e, lane, invocations, quadratic_count) {
    uvec4 c = FETCH(tet_vertices, FIRST_QUADRATIC + e), m = FETCH(mid_edges, 2u * e);
    uvec2 n = FETCH(mid_edges, 2u * e + 1u).xy;
    vec4 center = FETCH(predicted_centroid, e);
    vec3 moved = AT_CENTROID(displacement_of, c, m, n), speed = AT_CENTROID(velocity_of, c, m, n);
    vec3 place = AT_CENTROID(place_of, c, m, n) + moved;
    vec3 inertia = center.w * (moved - center.xyz), impulse = inertia + SUBSTEP * SUBSTEP * center.w * GRAVITY;
    bool moves = has_step != 0u && (is_free(c.x) || is_free(c.y) || is_free(c.z) || is_free(c.w) || is_free(m.x) || is_free(m.y) ||
                                    is_free(m.z) || is_free(m.w) || is_free(n.x) || is_free(n.y));
    float borne = 0.0;
#define BEAR(v, slot, share) borne += bear(v, slot, share, inertia, moves, impulse);
    uvec4 slot = FETCH(quadratic_slots, 3u * e);
    BEAR(c.x, slot.x, CORNER_AT_CENTROID)
    BEAR(c.y, slot.y, CORNER_AT_CENTROID)
    BEAR(c.z, slot.z, CORNER_AT_CENTROID)
    BEAR(c.w, slot.w, CORNER_AT_CENTROID)
    slot = FETCH(quadratic_slots, 3u * e + 1u);
    BEAR(m.x, slot.x, MIDDLE_AT_CENTROID)
    BEAR(m.y, slot.y, MIDDLE_AT_CENTROID)
    BEAR(m.z, slot.z, MIDDLE_AT_CENTROID)
    BEAR(m.w, slot.w, MIDDLE_AT_CENTROID)
    slot = FETCH(quadratic_slots, 3u * e + 2u);
    BEAR(n.x, slot.x, MIDDLE_AT_CENTROID)
    BEAR(n.y, slot.y, MIDDLE_AT_CENTROID)
    partial.angular += center.w * vec4(cross(place, speed), 0.5 * dot(speed, speed));
    partial.inertia.xyz += borne * impulse / (SUBSTEP * SUBSTEP);
  }
  centroid_partials[lane] = partial;
}
