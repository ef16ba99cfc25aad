// The coarse correction at every coarse node, R_j (A_c^-1 r)_j: three rows of the dense inverse each. With sums in groups a work
// group per node, else an invocation for every two, which share what they read of the right side. After coarse_restrict.
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
uniform uint nodes;       // at most, with TOUCHED
#define TWO !SUMS_IN_GROUPS

// The sum of the products, times UNIT: where integers are the upper halves of words, they need no shift.
#define UNIT 65536.0
float times(uvec4 eight, vec4 even, vec4 odd) {
  return dot(vec4(ivec4(eight << 16u)), even) + dot(vec4(ivec4(eight & 0xffff0000u)), odd);
}

vec3 rows_times(uint row, vec4 even, vec4 odd) {
  return vec3(times(FETCH(coarse_inverse, row), even, odd), times(FETCH(coarse_inverse, row + row_octets), even, odd),
              times(FETCH(coarse_inverse, row + 2u * row_octets), even, odd));
}

// `sum` of node j, or of touched node i, which is j.
void store(uint i, uint j, vec3 sum) {
  vec3 x = (1.0 / UNIT) * FETCH(coarse_scale, j).xyz * sum;
#if TOUCHED
  if (i >= FETCH1(coarse_touched, 0u)) x = vec3(0.0);
  STORE3(coarse_free[i], x)
#else
  vec4 q = FETCH(coarse_rotation, j);
  vec3 cross_x = cross(q.xyz, x);
  STORE3(coarse_correction[j], x + 2.0 * (q.w * cross_x + cross(q.xyz, cross_x)))
#endif
}

#if TOUCHED
#define NODE(i) (i < FETCH1(coarse_touched, 0u) ? FETCH1(coarse_touched, 1u + i) : 0u)
#else
#define NODE(i) i
#endif

void main() {
  SHARED_ITEM_OR_RETURN(item, lane)
#if TWO
  uint i = 2u * item, i2 = min(i + 1u, nodes - 1u), j2 = NODE(i2), row2 = 3u * j2 * row_octets;
  vec3 x2 = vec3(0.0);
#else
  uint i = item;
#endif
  uint j = NODE(i), row = 3u * j * row_octets;
#if TOUCHED
  uint end = i < FETCH1(coarse_touched, 0u) ? row_octets : 0u;
#else
  uint end = row_octets;
#endif
  vec3 x = vec3(0.0);
  for (uint k = lane; k < end; k += LANES) {
    vec4 low = FETCH(coarse_gradient, 2u * k), high = FETCH(coarse_gradient, 2u * k + 1u);
    vec4 even = vec4(low.xz, high.xz), odd = vec4(low.yw, high.yw);
    x += rows_times(row + k, even, odd);
#if TWO
    x2 += rows_times(row2 + k, even, odd);
#endif
  }
  SUM_OVER_LANES(x, lane)
  if (lane != 0u) return;
  store(i, j, x);
#if TWO
  store(i2, j2, x2);
#endif
}
