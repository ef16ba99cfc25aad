// The coarse correction at every coarse node, R_j (A_c^-1 r)_j: three rows of the dense inverse each. On GPUs a work
// group per node, else an invocation. After coarse_restrict.
// With CONTACT 1 the result, not rotated, is stored for coarse_contact; with CONTACT 2 the answer to what that kernel
// pushes back with is subtracted from it.
// The inverse is S C S, where the diagonal of C is constant. 16-bit integers represent C with enough accuracy for this
// correction and halve the data to read. S r comes from coarse_restrict.
#include "common/io.glsl"
#include "common/group_sum.glsl"
COMPUTE_1D
INPUT_UVEC4(CoarseInverse, coarse_inverse)   // [3 * node_count * row_octets] rows of C, eight 16-bit integers each,
                                             // padded with zeros
INPUT_VEC4(CoarseScale, coarse_scale)        // [node_count] xyz of S [1/sqrt(kg)]
INPUT_VEC4(CoarseGradient, coarse_gradient)  // [2 * row_octets] S R^T r, padded with zeros [sqrt(kg) m]
#if CONTACT == 1
OUTPUT(vec4, CoarseFreeNow, coarse_free_now)  // [node_count] not rotated [m]
#else
INPUT_VEC4(CoarseRotation, coarse_rotation)        // [node_count]
OUTPUT(vec4, CoarseCorrection, coarse_correction)  // [node_count] [m]
#endif
#if CONTACT == 2
INPUT_VEC4(CoarseFree, coarse_free)  // [node_count] of the run before
#endif
uniform uint row_octets;  // uvec4 per row

float times(uvec4 eight, vec4 even, vec4 odd) {
  return dot(vec4(ivec4(eight << 16u) >> 16), even) + dot(vec4(ivec4(eight) >> 16), odd);
}

void main() {
  SHARED_ITEM_OR_RETURN(j, lane)
  uint row = 3u * j * row_octets;
  vec3 x = vec3(0.0);
  for (uint k = lane; k < row_octets; k += LANES) {
    vec4 low = FETCH(coarse_gradient, 2u * k), high = FETCH(coarse_gradient, 2u * k + 1u);
    vec4 even = vec4(low.xz, high.xz), odd = vec4(low.yw, high.yw);
    x += vec3(times(FETCH(coarse_inverse, row + k), even, odd), times(FETCH(coarse_inverse, row + row_octets + k), even, odd),
              times(FETCH(coarse_inverse, row + 2u * row_octets + k), even, odd));
  }
  SUM_OVER_LANES(x, lane)
  if (lane != 0u) return;
  x *= FETCH(coarse_scale, j).xyz;
#if CONTACT == 1
  STORE3(coarse_free_now[j], x)
#else
#if CONTACT == 2
  x = FETCH(coarse_free, j).xyz - x;
#endif
  vec4 q = FETCH(coarse_rotation, j);
  vec3 cross_x = cross(q.xyz, x);
  STORE3(coarse_correction[j], x + 2.0 * (q.w * cross_x + cross(q.xyz, cross_x)))
#endif
}
