// How stiff rows are (sim/contact/row_stiffness.h), and what carries bodies: sums the forces with which pieces pressed each
// body at the end of the stage before, and the ways on which the velocities of the points that pressed lead. Those of other
// tissue are there already. In integers, whose sum is the same in any order. Over the listed points, among which all that
// pressed are. After contact_touched, before contact_start.
#include "common/io.glsl"
COMPUTE_1D
#include "common/step.glsl"
#include "sim/contact/piece.glsl"
#include "sim/contact/point.glsl"
#include "sim/contact/support.glsl"
INPUT_VEC4(ContactRest, contact_rest)              // [2 * points] point.glsl
INPUT_VEC4(StartDisplacement, start_displacement)  // [vertex_count] u at the start [m]
INPUT_VEC4(Displacement, displacement)             // [vertex_count] u where the iterations start [m]
INPUT_VEC4(ContactMemory, contact_memory)          // [rows] xyz t in the axes of the piece, w lambda [N]
INPUT_UINT(ContactNear, contact_near)              // [points] a bit for every piece that is near
#if CROWDED
INPUT_FLOAT(ContactCrowds, contact_crowds)         // [pieces * vertex_count] contact_touched.comp
uniform uint vertex_count;
#endif
OUTPUT(vec4, ContactAnchor, contact_anchor)        // [rows] of near rows, w k [N/m]
INOUT(uint, ContactBodies, contact_bodies)         // support.glsl
uniform uint bodies, points;

float crowd_at(uint piece, uvec4 vertices, vec4 weights) {
#if CROWDED
  uint first = piece * vertex_count;
  return max(1.0, weights.x * FETCH1(contact_crowds, first + vertices.x) + weights.y * FETCH1(contact_crowds, first + vertices.y) +
                      weights.z * FETCH1(contact_crowds, first + vertices.z));
#else
  return 1.0;
#endif
}

ivec3 units(vec3 v, float unit) {
  const float most = 1073741824.0;  // 2^30
  return ivec3(round(clamp(v / unit, -most, most)));
}

void add(uint first, ivec3 v) {
  atomicAdd(contact_bodies[first], uint(v.x));
  atomicAdd(contact_bodies[first + 1u], uint(v.y));
  atomicAdd(contact_bodies[first + 2u], uint(v.z));
}

void main() {
  ITEM_OR_RETURN(i)
#if PAIRS
  if (i >= points) return;
#endif
  uint body = contact_bodies[BODY_OF_POINT(i)];
  float weight = uintBitsToFloat(contact_bodies[MASS_OF_BODY(body)]) * UNIT_GRAVITY;
  vec3 force = vec3(0.0), friction = vec3(0.0), way = vec3(0.0), along = vec3(0.0), across = vec3(0.0);
  float bound = 0.0, pressing = 0.0;
  uvec4 vertices = FETCH(contact_vertices, i);
  vec4 weights = FETCH(contact_weights, i);
  uint near = FETCH1(contact_near, i);  // not 0: the point is listed
  do {  // llvmpipe runs the body of other loops once more
    uint piece = uint(findLSB(near));
    near &= near - 1u;
    uint row = first_row_of(piece) + i;
    contact_anchor[row].w = FETCH(contact_rest, 2u * i).w / crowd_at(piece, vertices, weights);
    vec4 memory = FETCH(contact_memory, row);
    if (memory.w <= 0.0) continue;
    PiecePose pose = pose_at_start(piece);
    vec3 start = AT_POINT(start_displacement, vertices, weights), x = FETCH(contact_rest, 2u * i).xyz + start;
    vec3 local = to_local(pose, x), normal = distance_to(piece, local).xyz;
#if MESHES
    normal = normalize(normal);
#endif
    force += pose.axes * (memory.w * normal + memory.xyz);
    way = AT_POINT(displacement, vertices, weights) - start - SUBSTEP * SUBSTEP * GRAVITY;
    PiecePose end = pose_at_end(piece);
    vec3 lacking = end.axes * local + end.origin - x - way;
    normal = pose.axes * normal;
    along = dot(lacking, normal) * normal;
    across = lacking - along;
    friction += pose.axes * memory.xyz;
    bound += friction_of(piece) * memory.w;
    pressing += memory.w;
  } while (near != 0u);
  if (weight <= 0.0) return;
  float fall = STAGE_DURATION * STAGE_DURATION * UNIT_GRAVITY, unit = WAY_UNIT * fall;
  weight *= SUPPORT_UNIT;
  ivec3 whole = units(force, weight);
  if (whole == ivec3(0)) return;
  uint sums = FORCE_OF_BODY(body);
  add(sums, whole);
  add(sums + 3u, units(way, unit));
  atomicAdd(contact_bodies[sums + 6u], 1u);
  add(sums + 7u, units(along, unit));
  add(sums + 10u, units(across, unit));
  add(sums + 13u, units(friction, weight));
  atomicAdd(contact_bodies[sums + 16u], uint(units(vec3(bound), weight).x));
  vec3 falls = (along + across) / fall;
  atomicAdd(contact_bodies[sums + 17u], uint(units(vec3(dot(falls, falls)), SQUARE_UNIT).x));
  atomicAdd(contact_bodies[sums + 18u], uint(units(vec3(pressing), weight).x));
}
