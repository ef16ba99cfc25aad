// Begins a stage at every listed point: the anchor of friction and the normal for the pieces that are near. How much of
// its way to the inertial start of the iterations, or of that of its body if it is carried (support.glsl), the point goes
// before it meets the piece limits where the iterations start. A point whose way leads through the piece, or so deep into
// it that another side is nearer, meets for this stage the plane at which it enters, as sim/tool/tool_entry.h states.
// After contact_support.
#include "common/io.glsl"
COMPUTE_1D
#include "sim/contact/piece.glsl"
#include "sim/contact/point.glsl"
#include "common/step.glsl"
#include "sim/contact/support.glsl"
INPUT_VEC4(ContactRest, contact_rest)              // [2 * points] point.glsl
INPUT_VEC4(StartDisplacement, start_displacement)  // [vertex_count] u at the start [m]
INPUT_VEC4(Displacement, displacement)             // [vertex_count] u where the iterations start [m]
INPUT_VEC4(ContactMemory, contact_memory)          // [rows] w lambda [N]
INPUT_UINT(ContactNear, contact_near)              // [points] a bit for every piece that is near
OUTPUT(vec4, ContactAnchor, contact_anchor)        // [rows] of near rows, u with which points go with the piece [m], w c of friction [N/m]
OUTPUT(vec4, ContactNormalNow, contact_normal_now)  // [rows] of near rows
INOUT(uint, ContactBodies, contact_bodies)         // support.glsl
uniform uint bodies, points;

// The share of the way from a to b, in the axes of the piece, at which it enters the piece; 1: not.
float entry_of(uint piece, vec3 a, vec3 way) {
  float size = length(way), share = 0.0;
  for (int k = 0; k < ENTRY_STEPS; ++k) {
    float d = distance_to(piece, a + share * way).w - half_thickness(piece);
    if (d <= 0.01 * size) return share;
    share += d / size;
    if (share >= 1.0) return 1.0;
  }
  return 1.0;
}

void main() {
  ITEM_OR_RETURN(i)
#if PAIRS
  if (i >= points) return;
#endif
  uvec4 vertices = FETCH(contact_vertices, i);
  vec4 weights = FETCH(contact_weights, i);
  vec3 start = AT_POINT(start_displacement, vertices, weights), way = AT_POINT(displacement, vertices, weights) - start;
  vec3 rest = FETCH(contact_rest, 2u * i).xyz, x = rest + start;
  uint body = contact_bodies[BODY_OF_POINT(i)], force = FORCE_OF_BODY(body), leader = contact_bodies[LEADER_OF_POINT(i)];
  float mass = uintBitsToFloat(contact_bodies[MASS_OF_BODY(body)]);
  if (is_carried(contact_bodies[force], contact_bodies[force + 1u], contact_bodies[force + 2u]))
    way = way_of_carried(contact_bodies[force + 3u], contact_bodies[force + 4u], contact_bodies[force + 5u], contact_bodies[force + 6u]);
  uint near = FETCH1(contact_near, i);  // not 0: the point is listed
  do {  // llvmpipe runs the body of other loops once more
    uint piece = uint(findLSB(near)), row = first_row_of(piece) + i;
    vec3 local = to_local(pose_at_start(piece), x);
    vec4 d = distance_to(piece, local), plane = vec4(0.0, 0.0, 0.0, NO_PLANE);
    PiecePose end = pose_at_end(piece);
    // On a piece that stands still that is u at the start, to the last bit: rounded, it would be a small slip in each step.
    vec3 anchor = same(pose_at_start(piece), end) ? start : end.axes * local + end.origin - rest;
    float penalty = share_of_penalty(piece) * FETCH(contact_rest, 2u * i).w;
    float sliding = max(STICKING * penalty, friction_of(piece) * FETCH(contact_memory, row).w / full_slip(piece));
    contact_anchor[row] = vec4(anchor, sliding);
    vec3 first = to_local(end, x), last = to_local(end, x + way), inward = last - first;
    vec4 d_last = distance_to(piece, last);
    float before = distance_to(piece, first).w, after = d_last.w, entry = 1.0;
    if (length(inward) > max(finest_radius(piece), before - half_thickness(piece))) entry = entry_of(piece, first, inward);
    if (entry < 1.0) {
      vec3 place = first + entry * inward;
      vec3 behind = first + min(1.0, entry + finest_radius(piece) / length(inward)) * inward;
      vec4 d_entry = distance_to(piece, place);
      float deepest = min(d_last.w, distance_to(piece, behind).w) - half_thickness(piece);
      if (deepest < -0.01 * length(inward) && dot(d_entry.xyz, d_last.xyz) < 0.5) {
        plane.xyz = end.axes * normalize(d_entry.xyz);
        plane.w = dot(plane.xyz, end.axes * place + end.origin) - d_entry.w;
        after = dot(plane.xyz, x + way) - plane.w;
      }
    }
    before -= half_thickness(piece);
    after -= half_thickness(piece);
    float in_by = least_depth(let_in(piece), penalty, mass, before - after);
    if (after < -in_by && after < before)
      atomicMin(contact_bodies[leader], floatBitsToUint(max(0.0, before + in_by) / (before - after)));
#if MESHES
    d.xyz = normalize(d.xyz);
#endif
    contact_normal_now[row] = plane.w == NO_PLANE ? vec4(end.axes * d.xyz, NO_PLANE) : plane;
    near &= near - 1u;
  } while (near != 0u);
}
