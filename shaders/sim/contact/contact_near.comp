// Begins a stage at every contact point: finds the pieces that it may touch within the stage. A point is near a piece
// that it pressed before, or if its distance at the start is less than twice its way to the inertial start of the
// iterations plus the way of the piece and a margin. All other work is over the list of these points. Before contact_list.
#include "common/io.glsl"
COMPUTE_1D
#include "sim/contact/piece.glsl"
#include "sim/contact/point.glsl"
INPUT_VEC4(ContactRest, contact_rest)              // [2 * points] point.glsl
INPUT_VEC4(StartDisplacement, start_displacement)  // [vertex_count] u at the start [m]
INPUT_VEC4(Displacement, displacement)             // [vertex_count] u where the iterations start [m]
INPUT_VEC4(ContactMemory, contact_memory)          // [rows] xyz t in the axes of the piece, w lambda [N]
OUTPUT(vec4, ContactBefore, contact_before)        // [rows] the memory at the start, for comparisons
OUTPUT(uint, ContactNear, contact_near)            // [points] a bit for every piece that is near
INOUT(uint, ContactCounts, contact_counts)         // [stretches] points of each stretch that are near; 0 before
OUTPUT(vec4, ContactAnchor, contact_anchor)        // [rows] 0; with CROWDED w of near rows: the force before, or else less the expected one [N] (sim/contact/row_stiffness.h)
OUTPUT(vec4, ContactForce, contact_force)          // [points] 0
OUTPUT(vec4, ContactBlock, contact_block)          // [2 * points] 0
uniform uint pieces;

// As has_row() of sim/contact/contact_surface.h, of a point that did not press.
bool has_row(uint piece, uint i, vec3 x) {
  bool has = i < points_everywhere(piece);
  if (!has) has = near_edge(piece, to_local(pose_at_start(piece), x)) || near_edge(piece, to_local(pose_at_end(piece), x));
  return has;
}

void main() {
  ITEM_OR_RETURN(i)
  uvec4 vertices = FETCH(contact_vertices, i);
  vec4 weights = FETCH(contact_weights, i);
  vec3 start = AT_POINT(start_displacement, vertices, weights), way = AT_POINT(displacement, vertices, weights) - start;
  vec3 x = FETCH(contact_rest, 2u * i).xyz + start;
  float reach = 2.0 * length(way);
  uint near = 0u, piece = 0u;
  do {  // llvmpipe runs the body of other loops once more
    if (i >= points_of(piece)) continue;
    uint row = first_row_of(piece) + i;
    float d = distance_to(piece, to_local(pose_at_start(piece), x)).w;
    vec4 memory = FETCH(contact_memory, row);
    contact_before[row] = memory;
    float pressing = 0.0;
    bool in_reach = d - half_thickness(piece) < reach + reach_of(piece);
    if (memory.w > 0.0 || in_reach && has_row(piece, i, x)) {
      near |= 1u << piece;
#if CROWDED
      float gap = distance_to(piece, to_local(pose_at_end(piece), x + way)).w - half_thickness(piece);
      pressing = memory.w > 0.0 ? memory.w : min(0.0, FETCH(contact_rest, 2u * i).w * (gap - first_reach(piece)));
#endif
    }
    contact_anchor[row] = vec4(0.0, 0.0, 0.0, pressing);
  } while (++piece < pieces);
  contact_near[i] = near;
  if (near != 0u) atomicAdd(contact_counts[i / uint(STRETCH)], 1u);
  contact_force[i] = vec4(0.0);
  contact_block[2u * i] = vec4(0.0);
  contact_block[2u * i + 1u] = vec4(0.0);
}
