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

void main() {
  ITEM_OR_RETURN(i)
#if PAIRS
  if (i >= points) return;
#endif
  uint body = contact_bodies[BODY_OF_POINT(i)];
  float weight = uintBitsToFloat(contact_bodies[MASS_OF_BODY(body)]) * length(GRAVITY);
  vec3 force = vec3(0.0), way = vec3(0.0);
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
    way = AT_POINT(displacement, vertices, weights) - start - SUBSTEP * SUBSTEP * GRAVITY;
    vec3 normal = distance_to(piece, to_local(pose, x)).xyz;
#if MESHES
    normal = normalize(normal);
#endif
    force += pose.axes * (memory.w * normal + memory.xyz);
  } while (near != 0u);
  const float most = 1073741824.0;  // 2^30
  ivec3 whole = weight > 0.0 ? ivec3(round(clamp(force / (SUPPORT_UNIT * weight), -most, most))) : ivec3(0);
  if (whole != ivec3(0)) {
    uint sums = FORCE_OF_BODY(body);
    ivec3 ways = ivec3(round(clamp(way / (WAY_UNIT * STAGE_DURATION * STAGE_DURATION * length(GRAVITY)), -most, most)));
    atomicAdd(contact_bodies[sums], uint(whole.x));
    atomicAdd(contact_bodies[sums + 1u], uint(whole.y));
    atomicAdd(contact_bodies[sums + 2u], uint(whole.z));
    atomicAdd(contact_bodies[sums + 3u], uint(ways.x));
    atomicAdd(contact_bodies[sums + 4u], uint(ways.y));
    atomicAdd(contact_bodies[sums + 5u], uint(ways.z));
    atomicAdd(contact_bodies[sums + 6u], 1u);
  }
}
