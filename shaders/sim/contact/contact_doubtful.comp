// Before contact_near, on software renderers, where tools are meshes: a distance to a mesh takes 27 nodes of its grid,
// which invocations in lockstep look up for all points if one of them does. Lists the points that may be near: those of
// the box of a grid, and of other pieces those that are. To the others, what contact_near writes.
#define DEFERS 1
#include "common/io.glsl"
COMPUTE_1D
#include "sim/contact/piece.glsl"
#include "sim/contact/point.glsl"
INPUT_VEC4(ContactRest, contact_rest)              // [2 * points] point.glsl
INPUT_VEC4(StartDisplacement, start_displacement)  // [vertex_count] u at the start [m]
INPUT_VEC4(Displacement, displacement)             // [vertex_count] u where the iterations start [m]
INPUT_VEC4(ContactMemory, contact_memory)          // [rows] xyz t in the axes of the piece, w lambda [N]
OUTPUT(vec4, ContactBefore, contact_before)        // [rows] the memory at the start
OUTPUT(uint, ContactNear, contact_near)            // [points] 0
OUTPUT(vec4, ContactAnchor, contact_anchor)        // [rows] 0
OUTPUT(vec4, ContactForce, contact_force)          // [points] 0
OUTPUT(vec4, ContactBlock, contact_block)          // [2 * points] 0
uniform uint pieces;

// [m] at most that of distance_to(): what is outside a grid is as far from its mesh as from the grid, at least.
float least_distance_to(uint piece, vec3 x) {
  float simple = simple_distance_to(piece, x).w;
  vec4 a = FETCH(contact_pieces, PIECE_ROWS * piece + 8u), b = FETCH(contact_pieces, PIECE_ROWS * piece + 9u);
  vec3 place = (x - a.xyz) / a.w;
  return is_mesh(piece) ? a.w * distance(place, clamp(place, vec3(0.5), b.xyz - 1.5)) : simple;
}

void main() {
  const float kRounding = 1.001;
  ITEM_OR_RETURN(i)
  uvec4 vertices = FETCH(contact_vertices, i);
  vec4 weights = FETCH(contact_weights, i);
  vec3 start = AT_POINT(start_displacement, vertices, weights), way = AT_POINT(displacement, vertices, weights) - start;
  vec3 x = FETCH(contact_rest, 2u * i).xyz + start;
  float reach = 2.0 * length(way);
  bool may_be_near = false;
  uint piece = 0u;
  do {  // llvmpipe runs the body of other loops once more
    if (i >= points_of(piece)) continue;
    uint row = first_row_of(piece) + i;
    vec4 memory = FETCH(contact_memory, row);
    contact_before[row] = memory;
    contact_anchor[row] = vec4(0.0);
    float d = least_distance_to(piece, to_local(pose_at_start(piece), x)) - half_thickness(piece);
    may_be_near = may_be_near || memory.w > 0.0 || d < kRounding * (reach + reach_of(piece));
  } while (++piece < pieces);
  contact_near[i] = 0u;
  contact_force[i] = vec4(0.0);
  contact_block[2u * i] = vec4(0.0);
  contact_block[2u * i + 1u] = vec4(0.0);
  if (may_be_near) defer(i);
}
