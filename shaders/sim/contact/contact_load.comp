// Force, torque and normal forces of every piece on the tissue, and the part of the force on held vertices: LOAD_LANES
// partial sums for each, which the CPU adds. After contact_finish.
#include "common/io.glsl"
COMPUTE_1D
#include "sim/contact/piece.glsl"
#include "sim/contact/point.glsl"
INPUT_VEC4(ContactRest, contact_rest)  // [2 * points] point.glsl
INPUT_VEC4(Displacement, displacement)      // [vertex_count] u [m]
INPUT_VEC4(ContactRow, contact_row)         // [rows] xyz force [N], w depth [m], -1 if apart
INPUT_VEC4(ContactMemory, contact_memory)   // [rows] w what is kept of the normal force [N]
INPUT_VEC4(ContactBefore, contact_before)   // [rows] the same at the start of the stage
INPUT_VEC4(RestPosition, rest_position)     // [vertex_count] w inverse mass, 0 if held
OUTPUT(vec4, ContactLoads, contact_loads)   // [3 * LOAD_LANES * pieces] xyz force, w points; xyz torque, w largest depth; x normal forces, yzw force on held vertices
uniform uint stage_share;                    // bits of the share of the stage that has ended (IntegratorStage::share)

void main() {
  ITEM_OR_RETURN(i)
  uint piece = i / uint(LOAD_LANES), lane = i % uint(LOAD_LANES), points = points_of(piece), first = first_row_of(piece);
  vec3 origin = FETCH(contact_pieces, PIECE_ROWS * piece + 10u).xyz;
  vec4 force = vec4(0.0), torque = vec4(0.0);
  vec4 others = vec4(0.0);
  float share = uintBitsToFloat(stage_share);
  for (uint p = lane; p < points; p += uint(LOAD_LANES)) {
    vec4 row = FETCH(contact_row, first + p);
    if (row.w == 0.0 && dot(row.xyz, row.xyz) == 0.0) continue;
    uvec4 vertices = FETCH(contact_vertices, p);
    vec4 weights = FETCH(contact_weights, p);
    vec3 x = FETCH(contact_rest, 2u * p).xyz + AT_POINT(displacement, vertices, weights);
    force += vec4(row.xyz, row.w >= 0.0 ? 1.0 : 0.0);
    torque.xyz += cross(x - origin, row.xyz);
    torque.w = max(torque.w, row.w);
    float kept = FETCH(contact_memory, first + p).w, before = FETCH(contact_before, first + p).w;
    others.x += max(0.0, (kept - (1.0 - share) * before) / share);  // of which kept_force() is the mean
    for (uint k = 0u; k < 3u; ++k)
      if (FETCH(rest_position, vertices[k]).w == 0.0) others.yzw += weights[k] * row.xyz;
  }
  contact_loads[3u * i] = force;
  contact_loads[3u * i + 1u] = torque;
  contact_loads[3u * i + 2u] = others;
}
