// Ends a stage at every listed point: the forces of its rows, which are read out, and the multipliers that the next
// stage starts with. Friction counts on from where rounding has left the point on what stands still: from where it was
// carried, a body at rest would creep by the rounding of each step.
#include "common/io.glsl"
COMPUTE_1D
#include "common/step.glsl"
#include "sim/contact/point.glsl"
INPUT_VEC4(ContactRest, contact_rest)  // [2 * points] point.glsl
#include "sim/contact/row.glsl"
#if PAIRS
#include "sim/contact/pair.glsl"
#endif
INPUT_VEC4(Displacement, displacement)       // [vertex_count] u [m]
INPUT_UINT(ContactNear, contact_near)        // [points]
INOUT(vec4, ContactMemoryNow, contact_memory_now)  // [rows] xyz t in the axes of the piece, w lambda [N]
INOUT(vec4, ContactRow, contact_row)         // [rows] the anchor, then the force on the tissue [N], w depth [m], -1 if apart
OUTPUT(vec4, ContactForce, contact_force)    // [points + pairs] xyz force, w the normal one [N]
#if MOVED_BODIES
// Bodies were moved as wholes to where these rows carry them. Those of rounded places do not where contact is stiff.
INPUT_VEC4(ContactMoved, contact_moved)      // [rows] xyz q [N], w -d [m], or NO_PLANE: of places
#endif

Row where_moved(Row r, uint row) {
#if MOVED_BODIES
  vec4 moved = FETCH(contact_moved, row);
  if (moved.w == NO_PLANE) return r;
  r.depth = moved.w;
  r.pressing = max(0.0, r.before + r.penalty * r.depth);
  if (r.bound > 0.0) r.across = moved.xyz;
#endif
  return r;
}

// What the next stage starts with: kept_force() of sim/contact/contact_block.h.
float kept_of(Row r) {
  float kept = STAGE_SHARE * r.pressing + (1.0 - STAGE_SHARE) * r.before;
  return kept > 1e-12 * r.penalty ? kept : 0.0;
}

void main() {
  ITEM_OR_RETURN(i)
  uvec4 vertices = FETCH(contact_vertices, i);
  vec4 weights = FETCH(contact_weights, i);
  vec3 u = AT_POINT(displacement, vertices, weights);
#if PAIRS
  if (i >= points) {
    uint pair = i - points, row = row_of_pair(pair);
    Row here = row_of(pair, u, contact_memory_now[row]), r = where_moved(here, row);
    float left = kept_of(r);
    contact_memory_now[row] = vec4(within(here.across, friction_of_pair(pair) * left), left);
    contact_force[i] = vec4(force_of(r), r.pressing);
    return;
  }
#endif
  vec4 rest = FETCH(contact_rest, 2u * i), force = vec4(0.0);
  vec4 more = FETCH(contact_rest, 2u * i + 1u);
  for (uint near = FETCH1(contact_near, i); near != 0u; near &= near - 1u) {
    uint piece = uint(findLSB(near)), row = first_row_of(piece) + i;
    Row here = row_at(piece, row, rest, more, u, contact_memory_now[row], contact_row[row]), r = where_moved(here, row);
    vec3 row_force = force_of(r), left = same(pose_at_start(piece), pose_at_end(piece)) ? here.across : r.across;
    float kept = kept_of(r);
    vec3 across = within(left, friction_of(piece) * kept);
    contact_memory_now[row] = vec4(across * pose_at_end(piece).axes, kept);
    contact_row[row] = vec4(row_force, r.pressing > 0.0 ? max(r.depth, 0.0) : -1.0);
    force += vec4(row_force, r.pressing);
  }
  contact_force[i] = force;
}
