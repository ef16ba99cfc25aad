// The depth of every row of the listed points as this machine computes it: from float32 places, so that it differs from
// that in double precision by some roundings of the coordinates, which stiff points press with.
#include "common/io.glsl"
COMPUTE_1D
#include "sim/contact/point.glsl"
INPUT_VEC4(ContactRest, contact_rest)  // [2 * points] point.glsl
#include "sim/contact/row.glsl"
#if PAIRS
#include "sim/contact/pair.glsl"
#endif
INPUT_VEC4(Displacement, displacement)     // [vertex_count] u [m]
INPUT_UINT(ContactNear, contact_near)      // [points]
OUTPUT(float, ContactDepth, contact_depth)  // [rows] of near rows -d [m]

void main() {
  ITEM_OR_RETURN(i)
#if PAIRS
  if (i >= points) return;
#endif
  uvec4 vertices = FETCH(contact_vertices, i);
  vec4 weights = FETCH(contact_weights, i), rest = FETCH(contact_rest, 2u * i);
  vec3 u = AT_POINT(displacement, vertices, weights);
  uint near = FETCH1(contact_near, i);  // not 0: the point is listed
  do {  // llvmpipe runs the body of other loops once more
    uint piece = uint(findLSB(near)), row = first_row_of(piece) + i;
    contact_depth[row] = row_at(piece, row, rest, 1.0, u, vec4(0.0), vec4(0.0)).depth;
    near &= near - 1u;
  } while (near != 0u);
}
