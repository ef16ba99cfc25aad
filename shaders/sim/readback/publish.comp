// Positions for drawing, x = X + u, with the heat map's scalar in w, in the vertex order of the model outside the
// solver (sim/ordering/mesh_order.h).
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(PlacedVertex, placed_vertex)  // [vertex_count]
INPUT_VEC4(RestPosition, rest_position)  // [vertex_count] X [m]
INPUT_VEC4(Displacement, displacement)   // [vertex_count] u [m]
#if HEAT_BY_TET
INPUT_UINT(SlotBegin, slot_begin)   // [vertex_count + 1]
INPUT_VEC4(Correction, correction)  // [slots] from heat_tet
#elif HEAT_BY_VERTEX
INPUT_FLOAT(VertexScalar, vertex_scalar)  // [vertex_count] also in that order
#elif HEAT_CONTACT
#include "sim/contact/pressure.glsl"
#elif HEAT_VELOCITY
INPUT_VEC4(Velocity, velocity)  // [vertex_count] v [m/s]
#endif
OUTPUT(vec4, Position, position)  // [vertex_count] in that order

void main() {
  ITEM_OR_RETURN(i)
  uint vertex = FETCH1(placed_vertex, i);
  vec3 u = FETCH(displacement, i).xyz;
  float scalar = HEAT_AT_REST;
#if HEAT_BY_TET
  vec2 sum = vec2(0.0);
  uint end = FETCH1(slot_begin, i + 1u);
  for (uint k = FETCH1(slot_begin, i); k < end; ++k) sum += FETCH(correction, k).xy;
  if (sum.y > 0.0) scalar = sum.x / sum.y;
#elif HEAT_BY_VERTEX
  scalar = FETCH1(vertex_scalar, vertex);
#elif HEAT_CONTACT
  scalar = contact_pressure(i);
#elif HEAT_VELOCITY
  scalar = length(FETCH(velocity, i).xyz);
#elif HEAT_DISPLACEMENT
  scalar = length(u);
#endif
  position[vertex] = vec4(FETCH(rest_position, i).xyz + u, scalar);
}
