// Restriction to the coarse space: the rotation R_j of every coarse node, nearest to the mean deformation gradient
// around it, M_j = I + sum_a u_a c_ja^T, and the gradient at the node, rotated back to the rest frame of the coarse
// matrix: S R_j^T sum_a P_aj g_a (S: coarse_solve). On GPUs a work group per node, else an invocation. After gradient.
// The rotation is the unit quaternion q that maximizes tr(R(q)^T M) = q^T K q (Davenport's problem): the leading
// eigenvector of K, by squaring K plus a shift that makes it positive. The result is always a rotation, even if M is
// singular or mirrored.
#include "common/io.glsl"
#include "common/group_sum.glsl"
COMPUTE_1D
INPUT_UINT(CoarseNodeBegin, coarse_node_begin)      // [2 * (node_count + 1)] first entry in gather_entry and in
                                                    // coarse_columns
INPUT_UVEC4(GatherEntry, gather_entry)              // [entries] xyz c_ja [1/m] (float bits), w vertex
INPUT_UVEC4(CoarseColumns, coarse_columns)          // two entries of P each: vertex and weight (float bits) alternating
INPUT_VEC4(Gradient, gradient)                      // [vertex_count] g [kg m]
INPUT_VEC4(Displacement, displacement)              // [vertex_count] u [m]
INPUT_VEC4(CoarseScale, coarse_scale)               // [node_count] xyz of S [1/sqrt(kg)]
OUTPUT(vec4, CoarseRotation, coarse_rotation)       // [node_count] quaternion, xyz vector and w scalar part
OUTPUT(float, CoarseGradient, coarse_gradient)      // [3 * node_count] [sqrt(kg) m]

vec4 nearest_rotation(mat3 m) {
  float trace = m[0].x + m[1].y + m[2].z;
  vec3 twist = vec3(m[1].z - m[2].y, m[2].x - m[0].z, m[0].y - m[1].x);
  float s01 = m[0].y + m[1].x, s02 = m[0].z + m[2].x, s12 = m[1].z + m[2].y;
  // Rows and columns in the order x, y, z, w.
  mat4 k = mat4(vec4(2.0 * m[0].x - trace, s01, s02, twist.x), vec4(s01, 2.0 * m[1].y - trace, s12, twist.y),
                vec4(s02, s12, 2.0 * m[2].z - trace, twist.z), vec4(twist, trace));
  // |eigenvalues of K| <= sum of the singular values of M <= sqrt(3) |M|. The shift is slightly larger: if the tissue
  // has collapsed to a point, M is 0 and the rotation the identity.
  float shift = 1e-6 + 1.7320508 * sqrt(dot(m[0], m[0]) + dot(m[1], m[1]) + dot(m[2], m[2]));
  k += mat4(shift);
  for (int i = 0; i < 10; ++i) {  // symmetric, so half of the products suffice
    k *= 1.0 / (k[0].x + k[1].y + k[2].z + k[3].w);
    float k01 = dot(k[0], k[1]), k02 = dot(k[0], k[2]), k03 = dot(k[0], k[3]), k12 = dot(k[1], k[2]), k13 = dot(k[1], k[3]), k23 = dot(k[2], k[3]);
    k = mat4(vec4(dot(k[0], k[0]), k01, k02, k03), vec4(k01, dot(k[1], k[1]), k12, k13), vec4(k02, k12, dot(k[2], k[2]), k23),
             vec4(k03, k13, k23, dot(k[3], k[3])));
  }
  // The longest column of the resulting projection.
  vec4 q = k[3];
  if (k[0].x > max(k[1].y, max(k[2].z, k[3].w))) q = k[0];
  else if (k[1].y > max(k[2].z, k[3].w)) q = k[1];
  else if (k[2].z > k[3].w) q = k[2];
  return q * inversesqrt(dot(q, q));
}

void main() {
  SHARED_ITEM_OR_RETURN(j, lane)
  vec3 m0 = vec3(0.0), m1 = vec3(0.0), m2 = vec3(0.0), r = vec3(0.0);
  uint end = FETCH1(coarse_node_begin, 2u * j + 2u);
  for (uint k = FETCH1(coarse_node_begin, 2u * j) + lane; k < end; k += LANES) {
    uvec4 entry = FETCH(gather_entry, k);
    vec3 c = uintBitsToFloat(entry.xyz), u = FETCH(displacement, entry.w).xyz;
    m0 += c.x * u;
    m1 += c.y * u;
    m2 += c.z * u;
  }
  end = FETCH1(coarse_node_begin, 2u * j + 3u);
  for (uint k = FETCH1(coarse_node_begin, 2u * j + 1u) + lane; k < end; k += LANES) {
    uvec4 entries = FETCH(coarse_columns, k);
    r += uintBitsToFloat(entries.y) * FETCH(gradient, entries.x).xyz;
    r += uintBitsToFloat(entries.w) * FETCH(gradient, entries.z).xyz;
  }
  SUM_OVER_LANES(m0, lane)
  SUM_OVER_LANES(m1, lane)
  SUM_OVER_LANES(m2, lane)
  SUM_OVER_LANES(r, lane)
  if (lane != 0u) return;
  vec4 q = nearest_rotation(mat3(1.0) + mat3(m0, m1, m2));
  coarse_rotation[j] = q;
  vec3 cross_r = cross(-q.xyz, r);
  vec3 back = FETCH(coarse_scale, j).xyz * (r + 2.0 * (q.w * cross_r + cross(-q.xyz, cross_r)));
  coarse_gradient[3u * j] = back.x;
  coarse_gradient[3u * j + 1u] = back.y;
  coarse_gradient[3u * j + 2u] = back.z;
}
