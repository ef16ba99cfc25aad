// Rigid pieces of tools: poses and signed distances (sim/tool/shape_distance.h). The defines CAPSULES, BOXES, PLANES,
// CYLINDERS and MESHES say which shapes there are; a sphere is a capsule without a length.
#define PIECE_ROWS 14u
#define MOST_PIECES 32u
#define NO_PLANE 3e38
INPUT_VEC4(ContactPieces, contact_pieces)  // [PIECE_ROWS * pieces]: sim/gpu/contact/contact_term.cpp

struct PiecePose {
  mat3 axes;
  vec3 origin;
};

PiecePose pose_at(uint row) {
  return PiecePose(mat3(FETCH(contact_pieces, row).xyz, FETCH(contact_pieces, row + 1u).xyz, FETCH(contact_pieces, row + 2u).xyz),
                   FETCH(contact_pieces, row + 3u).xyz);
}
PiecePose pose_at_end(uint piece) { return pose_at(PIECE_ROWS * piece); }
PiecePose pose_at_start(uint piece) { return pose_at(PIECE_ROWS * piece + 4u); }
bool same(PiecePose a, PiecePose b) { return a.axes == b.axes && a.origin == b.origin; }
vec3 to_local(PiecePose pose, vec3 x) { return (x - pose.origin) * pose.axes; }

float friction_of(uint piece) { return FETCH(contact_pieces, PIECE_ROWS * piece).w; }
float full_slip(uint piece) { return FETCH(contact_pieces, PIECE_ROWS * piece + 1u).w; }  // [m] after which points bear all friction
float reach_of(uint piece) { return FETCH(contact_pieces, PIECE_ROWS * piece + 2u).w; }
float half_thickness(uint piece) { return FETCH(contact_pieces, PIECE_ROWS * piece + 3u).w; }
float let_in(uint piece) { return FETCH(contact_pieces, PIECE_ROWS * piece + 7u).w; }  // [m] by which iterations may start inside
float finest_radius(uint piece) { return FETCH(contact_pieces, PIECE_ROWS * piece + 10u).w; }
// What float32 loses [m] of where the piece is at the end; of a distance beside it, with a local normal, by its sizes.
vec3 lost_place(uint piece) { return FETCH(contact_pieces, PIECE_ROWS * piece + 11u).xyz; }
float lost_distance(uint piece, vec3 normal) {
  vec4 lost = FETCH(contact_pieces, PIECE_ROWS * piece + 12u);  // of half sizes, of the radius
  return -dot(abs(normal), lost.xyz) - lost.w;
}
uint first_row_of(uint piece) { return uint(FETCH(contact_pieces, PIECE_ROWS * piece + 5u).w); }
uint points_everywhere(uint piece) { return uint(FETCH(contact_pieces, PIECE_ROWS * piece + 13u).x); }  // others near edges only
float edge_width(uint piece) { return FETCH(contact_pieces, PIECE_ROWS * piece + 13u).y; }             // [m] what near is
float first_reach(uint piece) { return FETCH(contact_pieces, PIECE_ROWS * piece + 13u).z; }             // [m] sim/contact/contact_surface.h
float round_of(uint piece) { return FETCH(contact_pieces, PIECE_ROWS * piece + 13u).w; }                // [m] of a cylinder
uint points_of(uint piece) { return uint(FETCH(contact_pieces, PIECE_ROWS * piece + 6u).w); }

vec4 from_core(vec3 away, float radius) {
  float length2 = dot(away, away);
  return length2 > 0.0 ? vec4(away * inversesqrt(length2), sqrt(length2) - radius) : vec4(0.0, 1.0, 0.0, -radius);
}

#if CAPSULES
// a: from, radius; b: to - from, 1 / |b|^2.
vec4 capsule_distance(vec4 a, vec4 b, vec3 x) {
  return from_core(x - a.xyz - clamp(dot(x - a.xyz, b.xyz) * b.w, 0.0, 1.0) * b.xyz, a.w);
}
#endif
#if BOXES
// a: center, radius of the edges; b: half sizes less that radius.
vec4 box_distance(vec4 a, vec4 b, vec3 x) {
  vec3 local = x - a.xyz, side = vec3(local.x < 0.0 ? -1.0 : 1.0, local.y < 0.0 ? -1.0 : 1.0, local.z < 0.0 ? -1.0 : 1.0);
  vec3 beyond = abs(local) - b.xyz;
  float depth = max(beyond.x, max(beyond.y, beyond.z));
  if (depth > 0.0) return from_core(side * max(beyond, 0.0), a.w);
  vec3 face = beyond.x == depth ? vec3(1.0, 0.0, 0.0) : beyond.y == depth ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
  return vec4(side * face, depth - a.w);
}
#endif
#if CYLINDERS
// Of its core, which is smaller by the radius of its edges `rim`: a: middle, radius; b: axis, half height.
vec4 cylinder_distance(vec4 a, vec4 b, float rim, vec3 x) {
  vec3 local = x - a.xyz;
  float height = dot(local, b.xyz), side = height < 0.0 ? -1.0 : 1.0;
  vec3 across = local - height * b.xyz;
  float radial = length(across);
  // At the axis any direction across it serves: the flat ends are nearer, or the cylinder is a needle.
  vec3 outward = radial > 0.0 ? across / radial : normalize(cross(b.xyz, abs(b.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
  float past_rim = radial - a.w, past_end = abs(height) - b.w;
  if (past_rim > 0.0 && past_end > 0.0) return from_core(past_rim * outward + past_end * side * b.xyz, rim);
  return past_rim > past_end ? vec4(outward, past_rim - rim) : vec4(side * b.xyz, past_end - rim);
}
#endif
#if MESHES
#include "sim/contact/mesh_distance.glsl"
#endif

bool is_mesh(uint piece) { return FETCH(contact_pieces, PIECE_ROWS * piece + 4u).w == 4.0; }

// In the axes of the piece: xyz normal, w signed distance [m]. Of all pieces but meshes.
vec4 simple_distance_to(uint piece, vec3 x) {
  float shape = FETCH(contact_pieces, PIECE_ROWS * piece + 4u).w;
  vec4 a = FETCH(contact_pieces, PIECE_ROWS * piece + 8u), b = FETCH(contact_pieces, PIECE_ROWS * piece + 9u);
  vec4 result = vec4(0.0, 1.0, 0.0, 3.4e38);
#if CAPSULES
  if (shape == 0.0) result = capsule_distance(a, b, x);
#endif
#if BOXES
  if (shape == 1.0) result = box_distance(a, b, x);
#endif
#if PLANES
  if (shape == 2.0) result = vec4(b.xyz, dot(x - a.xyz, b.xyz));
#endif
#if CYLINDERS
  if (shape == 3.0) result = cylinder_distance(a, b, round_of(piece), x);
#endif
  return result;
}

// The same, of all.
vec4 distance_to(uint piece, vec3 x) {
  vec4 result = simple_distance_to(piece, x);
#if MESHES
  vec4 a = FETCH(contact_pieces, PIECE_ROWS * piece + 8u), b = FETCH(contact_pieces, PIECE_ROWS * piece + 9u);
  if (is_mesh(piece)) result = mesh_distance(a, b, x);
#endif
  return result;
}

// Whether a place in the axes of the piece is near one of its edges (sim/tool/shape_distance.h).
bool near_edge(uint piece, vec3 x) {
  float shape = FETCH(contact_pieces, PIECE_ROWS * piece + 4u).w, width = edge_width(piece);
  vec4 a = FETCH(contact_pieces, PIECE_ROWS * piece + 8u), b = FETCH(contact_pieces, PIECE_ROWS * piece + 9u);
  bool result = false;
#if BOXES
  if (shape == 1.0) {
    bvec3 beyond = greaterThan(abs(x - a.xyz) - b.xyz - a.w, vec3(-width));
    result = int(beyond.x) + int(beyond.y) + int(beyond.z) >= 2;
  }
#endif
#if CYLINDERS
  if (shape == 3.0) {
    float height = dot(x - a.xyz, b.xyz), across = length(x - a.xyz - height * b.xyz);
    result = across - a.w - round_of(piece) > -width && abs(height) - b.w - round_of(piece) > -width;
  }
#endif
  return result;
}
