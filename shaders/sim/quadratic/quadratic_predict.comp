// u~ of what moves at the centroid of every quadratic tet (sim/elements/quadratic_tet.h), from that of its vertices, of
// which constrained ones lack gravity. After predict.
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/quadratic_tet.glsl"
COMPUTE_1D
INPUT_VEC4(Predicted, predicted)  // [vertex_count] xyz u~ [m], w inverse mass, 0 where constrained
INOUT(vec4, PredictedCentroid, predicted_centroid)  // [quadratic_count] xyz u~ [m], w mass [kg], which stays

vec3 predicted_of(uint v) {
  vec4 predicted_v = FETCH(predicted, v);
  return predicted_v.w > 0.0 ? predicted_v.xyz : predicted_v.xyz + SUBSTEP * SUBSTEP * GRAVITY;
}

void main() {
  ITEM_OR_RETURN(e)
  uvec4 c = FETCH(tet_vertices, FIRST_QUADRATIC + e), m = FETCH(mid_edges, 2u * e);
  uvec2 n = FETCH(mid_edges, 2u * e + 1u).xy;
  predicted_centroid[e].xyz = AT_CENTROID(predicted_of, c, m, n);
}
