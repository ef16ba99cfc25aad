// What moves at the centroids of quadratic tets: its share of angular momentum, kinetic energy and inertia, of which
// every free middle's slot receives its part, -M (u - u~). Supports accelerate centroids beside free middles: the slot of
// a held one receives -h^2 times mass and acceleration, since its weight is that of lumped masses. After
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

// Whether a middle is free, 1 or 0. Its slot receives the inertia.
float bear(uint v, uint slot, vec3 inertia) {
  if (!(FETCH(predicted, v).w > 0.0)) return 0.0;
  correction[slot].xyz -= inertia;
  return 1.0;
}

// The same of a held middle.
float pass_on(uint v, uint slot, vec3 impulse) {
  if (FETCH(rest_position, v).w > 0.0) return 0.0;
  correction[slot].xyz -= impulse;
  return 1.0;
}

void main() {
  ITEM_OR_RETURN(lane)
  CentroidPartial partial = CentroidPartial(vec4(0.0), vec4(0.0));
  FOR_ITEMS_OF_LANE(e, lane, invocations, quadratic_count) {
    uvec4 m = FETCH(mid_edges, 2u * e);
    uvec2 n = FETCH(mid_edges, 2u * e + 1u).xy;
    vec4 center = FETCH(predicted_centroid, e);
    vec3 moved = MEAN_OF_MIDDLES(displacement, m, n), speed = MEAN_OF_MIDDLES(velocity, m, n);
    vec3 place = MEAN_OF_MIDDLES(rest_position, m, n) + moved;
    vec3 inertia = center.w / 6.0 * (moved - center.xyz);  // share of a middle
    uvec4 slot = FETCH(quadratic_slots, 3u * e + 1u);
    uvec2 last_slots = FETCH(quadratic_slots, 3u * e + 2u).xy;
    float parts = bear(m.x, slot.x, inertia) + bear(m.y, slot.y, inertia) + bear(m.z, slot.z, inertia) + bear(m.w, slot.w, inertia) +
                  bear(n.x, last_slots.x, inertia) + bear(n.y, last_slots.y, inertia);
    if (parts > 0.0 && has_step != 0u) {
      vec3 impulse = inertia + SUBSTEP * SUBSTEP * center.w / 6.0 * GRAVITY;
      parts += pass_on(m.x, slot.x, impulse) + pass_on(m.y, slot.y, impulse) + pass_on(m.z, slot.z, impulse) +
               pass_on(m.w, slot.w, impulse) + pass_on(n.x, last_slots.x, impulse) + pass_on(n.y, last_slots.y, impulse);
    }
    partial.angular += center.w * vec4(cross(place, speed), 0.5 * dot(speed, speed));
    partial.inertia.xyz += parts * (inertia / (SUBSTEP * SUBSTEP) + center.w / 6.0 * GRAVITY);
  }
  centroid_partials[lane] = partial;
}
