// Smallest and largest scalar of the heat map. Each invocation processes its share of the vertices; the CPU combines
// the results. Reads the output of publish. Values that are not finite are left out, since the state guard reports
// them.
#include "common/io.glsl"
COMPUTE_1D
INPUT_VEC4(Position, position)                 // [vertex_count] w: scalar
OUTPUT(vec4, RangePartials, range_partials)    // [invocations] x smallest, y largest
uniform uint vertex_count;

void main() {
  ITEM_OR_RETURN(i)
  vec2 range = vec2(3.4e38, -3.4e38);
  FOR_ITEMS_OF_LANE(v, i, invocations, vertex_count) {
    float scalar = FETCH(position, v).w;
    if (abs(scalar) < 3.0e38) range = vec2(min(range.x, scalar), max(range.y, scalar));
  }
  range_partials[i] = vec4(range, 0.0, 0.0);
}
