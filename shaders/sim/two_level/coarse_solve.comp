// The coarse correction at every coarse node, R_j (A_c^-1 r)_j: three rows of the dense inverse each. On GPUs a work
// group per node, else an invocation. After coarse_restrict.
// With TOUCHED only at the nodes that contact touches, not rotated, for coarse_contact, after which a run without it
// gives the correction.
// The inverse is S C S, where the diagonal of C is constant. 16-bit integers represent C with enough accuracy for this
// correction and halve the data to read. S r comes from coarse_restrict.
#include "common/io.glsl"
#include "common/group_sum.glsl"
COMPUTE_1D
INPUT_UVEC4(CoarseInverse, coarse_inverse)   // [3 * node_count * row_octets] rows of C, eight 16-bit integers each,
                                             // padded with zeros
INPUT_VEC4(CoarseScale, coarse_scale)        // [node_count] xyz of S [1/sqrt(kg)]
INPUT_VEC4(CoarseGradient, coarse_gradient)  // [2 * row_octets] S R^T r, padded with zeros [sqrt(kg) m]
#if TOUCHED
INPUT_UINT(CoarseTouched, coarse_touched)  // [0] the number of nodes, then the nodes
OUTPUT(vec4, CoarseFree, coarse_free)      // [nodes] not rotated [m], then zeros
#else
INPUT_VEC4(CoarseRotation, coarse_rotation)        // [node_count]
OUTPUT(vec4, CoarseCorrection, coarse_correction)  // [node_count] [m]
#endif
uniform uint row_octets;  // uvec4 per row

float times(uvec4 eight, vec4 even, vec4 odd) {
  return dot(vec4(ivec4(eight << 16u) >> 16), even) + dot(vec4(ivec4(eight) >> 16), odd);
}

void main() {
#if TOUCHED
  SHARED_ITEM_OR_RETURN(i, lane)
  bool touched = i < FETCH1(coarse_touched, 0u);
  uint j = touched ? FETCH1(coarse_touched, 1u + i) : 0u, end = touched ? row_octets : 0u;
#else
  SHARED_ITEM_OR_RETURN(j, lane)
  uint end = row_octets;
#endif
  uint row = 3u * j * row_octets;
  vec3 x = vec3(0.0);
  for (uint k = lane; k < end; k += LANES) {
    vec4 low = FETCH(coarse_gradient, 2u * k), high = FETCH(coarse_gradient, 2u * k + 1u);
    vec4 even = vec4(low.xz, high.xz), odd = vec4(low.yw, high.yw);
    x += vec3(times(FETCH(coarse_inverse, row + k), even, odd), times(FETCH(coarse_inverse, row + row_octets + k), even, odd),
              times(FETCH(coarse_inverse, row + 2u * row_octets + k), even, odd));
  }
  SUM_OVER_LANES(x, lane)
  if (lane != 0u) return;
  x *= FETCH(coarse_scale, j).xyz;
#if TOUCHED
  STORE3(coarse_free[i], x)
#else
  vec4 q = FETCH(coarse_rotation, j);
  vec3 cross_x = cross(q.xyz, x);
  STORE3(coarse_correction[j], x + 2.0 * (q.w * cross_x + cross(q.xyz, cross_x)))
#endif
}
