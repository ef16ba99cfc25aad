// Smallest and largest scalar of the heat map. Each invocation walks through its share of the vertices; the CPU finishes the sum.
// Reads what publish has written. What is not finite is left out: the state guard speaks of it.
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
