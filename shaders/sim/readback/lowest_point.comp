// The lowest y of the drawn vertices. Each invocation processes its share of them; the CPU combines the results. Reads
// the output of publish. Positions that are not finite are left out, since the state guard reports them.
#include "common/io.glsl"
COMPUTE_1D
INPUT_VEC4(Position, position)                  // [vertex_count] xyz [m]
INPUT_UINT(DrawnVertex, drawn_vertex)           // [drawn_count]
OUTPUT(float, LowestPartials, lowest_partials)  // [invocations]
uniform uint drawn_count;

void main() {
  ITEM_OR_RETURN(i)
  float lowest = 3.4e38;
  FOR_ITEMS_OF_LANE(d, i, invocations, drawn_count) {
    float y = FETCH(position, FETCH1(drawn_vertex, d)).y;
    if (abs(y) < 3.0e38) lowest = min(lowest, y);
  }
  lowest_partials[i] = lowest;
}
