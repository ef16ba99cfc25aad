// Begins a stage at every listed point: the anchor of friction and the normal for the pieces that are near. How much of
// its way to the inertial start of the iterations, or of that of its body if it is carried (support.glsl), the point goes
// before it meets the piece limits where the iterations start. A point whose way against the piece leads through it, or so
// deep into it that another side is nearer, meets for this stage the plane at which it enters, as sim/tool/tool_entry.h
// states.
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
INPUT_UINT(ContactNear, contact_near)              // [points] a bit for every piece that is near
INOUT(vec4, ContactAnchor, contact_anchor)         // [rows] of near rows, u with which points go with the piece [m], w k [N/m]
OUTPUT(vec4, ContactNormalNow, contact_normal_now)  // [rows] of near rows
INOUT(uint, ContactBodies, contact_bodies)         // support.glsl
uniform uint bodies, points;
#define BODY_WORD(word) contact_bodies[word]

// The share of a way in the axes of the piece at which it enters the piece; 1: not.
float entry_of(uint piece, vec3 from, vec3 way) {
  float size = length(way), share = 0.0;
  for (int k = 0; k < ENTRY_STEPS; ++k) {
    float d = distance_to(piece, from + share * way).w - half_thickness(piece);
    if (d <= 0.01 * size) return share;
    share += d / size;
    if (share >= 1.0) return 1.0;
  }
  return 1.0;
}

// The plane in the scene that stands for the piece on this way; w NO_PLANE: none. `gap`: at its start.
vec4 plane_on(uint piece, PiecePose end, vec3 from, vec3 to, float gap) {
  vec4 none = vec4(0.0, 0.0, 0.0, NO_PLANE);
  vec3 way = to - from;
  float size = length(way);
  if (size <= max(finest_radius(piece), gap)) return none;
  float entry = entry_of(piece, from, way);
  if (entry == 1.0) return none;
  vec3 place = from + entry * way;
  vec4 d_entry = distance_to(piece, place), d_last = distance_to(piece, to);
  vec4 d_behind = distance_to(piece, from + min(1.0, entry + finest_radius(piece) / size) * way);
  float deepest = min(d_last.w, d_behind.w) - half_thickness(piece);
  if (deepest >= -0.01 * size || dot(d_entry.xyz, d_last.xyz) >= 0.5) return none;
  vec3 normal = end.axes * normalize(d_entry.xyz);
  return vec4(normal, dot(normal, end.axes * place + end.origin) - d_entry.w);
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
  if (IS_CARRIED(force)) way = WAY_OF_CARRIED(force);
  uint near = FETCH1(contact_near, i);  // not 0: the point is listed
  do {  // llvmpipe runs the body of other loops once more
    uint piece = uint(findLSB(near)), row = first_row_of(piece) + i;
    vec3 local = to_local(pose_at_start(piece), x);
    vec4 d = distance_to(piece, local), plane;
    PiecePose end = pose_at_end(piece);
    // On a piece that stands still that is u at the start, to the last bit: rounded, it would be a small slip in each step.
    vec3 anchor = same(pose_at_start(piece), end) ? start : end.axes * local + end.origin - rest;
    float penalty = contact_anchor[row].w;
    contact_anchor[row].xyz = anchor;
    vec3 last = to_local(end, x + way), stay = to_local(end, x);
    float gap = d.w - half_thickness(piece);
    plane = plane_on(piece, end, local, last, gap);
    if (plane.w == NO_PLANE) plane = plane_on(piece, end, local, stay, gap);
    float before = distance_to(piece, stay).w, after = distance_to(piece, last).w;
    if (plane.w != NO_PLANE) {
      before = dot(plane.xyz, x) - plane.w;
      after = dot(plane.xyz, x + way) - plane.w;
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
