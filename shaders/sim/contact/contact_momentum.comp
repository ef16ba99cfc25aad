// Bodies that press each other and nothing else keep their momentum: moves each such group as a whole to where its
// momentum is that of the inertial motion. Neither elastic forces nor those between the bodies change with that, so that
// this is the exact step along these directions. Iterations find them late: where stiff bodies collide, ten lose up to
// two thirds of it. Angular momentum is not an invariant of a step: the normals of pairs are constant in it. At the end of the
// iterations, before contact_finish.
#include "common/io.glsl"
COMPUTE_1D
#include "common/group_sum.glsl"
#include "common/step.glsl"
#include "sim/contact/support.glsl"
INPUT_UINT(ContactGroups, contact_groups)  // [bodies] first body of its group, NO_BODY for those that something holds
INPUT_UINT(ContactBodies, contact_bodies)  // support.glsl
INPUT_UINT(ContactBody, contact_body)      // [2 * vertex_count] -, own body or NO_BODY
INPUT_UINT(ContactNear, contact_near)      // [points]
INPUT_VEC4(RestPosition, rest_position)    // [vertex_count] xyz X [m], w inverse mass [1/kg]
INPUT_VEC4(Predicted, predicted)           // [vertex_count] u~ [m]
INOUT(vec4, Displacement, displacement)    // [vertex_count] u [m]
uniform uint bodies, points, vertex_count;
#define NO_BODY 0xffffffffu

bool is_of(uint body, uint group) { return body != NO_BODY && FETCH1(contact_groups, body) == group; }
// Vertices without tets have no mass.
#define OF_GROUP(v, group, lane)                    \
  for (uint v = lane; v < vertex_count; v += LANES) \
    if (is_of(FETCH1(contact_body, 2u * v + 1u), group) && FETCH(rest_position, v).w > 0.0)

void main() {
  SHARED_ITEM_OR_RETURN(group, lane)
  if (FETCH1(contact_groups, group) != group) return;
  vec3 mass = vec3(0.0), way = vec3(0.0);  // x: the mass, y: points near a tool
  for (uint p = lane; p < points; p += LANES)
    if (is_of(FETCH1(contact_bodies, BODY_OF_POINT(p)), group) && FETCH1(contact_near, p) != 0u) mass.y += 1.0;
  OF_GROUP(v, group, lane) {
    float m = 1.0 / FETCH(rest_position, v).w;
    mass.x += m;
    way += m * (FETCH(predicted, v).xyz - displacement[v].xyz);
  }
  SUM_FOR_ALL_LANES(mass, lane)
  SUM_FOR_ALL_LANES(way, lane)
  if (mass.y > 0.0) return;
  way /= mass.x;

  OF_GROUP(v, group, lane) displacement[v].xyz += way;
}
