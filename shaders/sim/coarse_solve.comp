// The coarse correction at every coarse node, R_j (A_c^-1 r)_j: three rows of the dense inverse each. On GPUs a work group per
// node, else an invocation. After coarse_restrict.
#include "common/io.glsl"
#include "common/group_sum.glsl"
COMPUTE_1D
INPUT_VEC4(CoarseInverse, coarse_inverse)    // [3 * node_count * row_quads] rows of A_c^-1, padded with zeros [1/kg]
INPUT_VEC4(CoarseGradient, coarse_gradient)  // [row_quads] R^T r, padded with zeros [kg m]
INPUT_VEC4(CoarseRotation, coarse_rotation)  // [node_count]
OUTPUT(vec4, CoarseCorrection, coarse_correction)  // [node_count] [m]
uniform uint row_quads;  // vec4 per row

void main() {
  SHARED_ITEM_OR_RETURN(j, lane)
  uint row = 3u * j * row_quads;
  vec3 x = vec3(0.0);
  for (uint k = lane; k < row_quads; k += LANES) {
    vec4 r = FETCH(coarse_gradient, k);
    x += vec3(dot(FETCH(coarse_inverse, row + k), r), dot(FETCH(coarse_inverse, row + row_quads + k), r),
              dot(FETCH(coarse_inverse, row + 2u * row_quads + k), r));
  }
  SUM_OVER_LANES(x, lane)
  if (lane != 0u) return;
  vec4 q = FETCH(coarse_rotation, j);
  vec3 cross_x = cross(q.xyz, x);
  STORE3(coarse_correction[j], x + 2.0 * (q.w * cross_x + cross(q.xyz, cross_x)))
}
