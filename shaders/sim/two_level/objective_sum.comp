// Sums the objective of the step over the vertices, into the w of the partials that subspace_solve reads. After
// gradient.
#include "common/io.glsl"
#include "common/reduce.glsl"
COMPUTE_1D
INPUT_VEC4(Gradient, gradient)             // [vertex_count] w objective [kg m^2]
OUTPUT(vec4, DotPartials, dot_partials)
uniform uint vertex_count;

void main() {
  LANE_OR_RETURN(i)
  float sum = 0.0;
  FOR_ITEMS_OF_LANE(k, i, invocations, vertex_count) sum += FETCH(gradient, LISTED_ITEM(k)).w;
  STORE_PARTIAL(dot_partials, i, vec4(0.0, 0.0, 0.0, sum))
}
