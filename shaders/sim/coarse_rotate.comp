// The rotation nearest to the mean deformation gradient M of every coarse node, and the node's gradient turned back into the rest
// frame, where the coarse matrix lives: R_j^T r_j. After coarse_restrict.
// The rotation is the unit quaternion q that maximises tr(R(q)^T M) = q^T K q (Davenport's problem): the leading eigenvector of K,
// by squaring K plus a shift that makes it positive. Always a rotation, also where M is singular or mirrored.
#include "common/io.glsl"
COMPUTE_1D
INPUT_VEC4(CoarsePartials, coarse_partials)  // [3 * lanes * node_count]
OUTPUT(vec4, CoarseRotation, coarse_rotation)  // [node_count] quaternion, xyz vector and w scalar part
OUTPUT(float, CoarseGradient, coarse_gradient)  // [3 * node_count] R_j^T r_j [kg m]
uniform uint lanes;

void main() {
  ITEM_OR_RETURN(j)
  vec4 c0 = vec4(0.0), c1 = vec4(0.0), c2 = vec4(0.0);
  for (uint k = lanes * j; k < lanes * (j + 1u); ++k) {
    c0 += FETCH(coarse_partials, 3u * k);
    c1 += FETCH(coarse_partials, 3u * k + 1u);
    c2 += FETCH(coarse_partials, 3u * k + 2u);
  }
  mat3 m = mat3(1.0) + mat3(c0.xyz, c1.xyz, c2.xyz);
  float trace = m[0].x + m[1].y + m[2].z;
  vec3 twist = vec3(m[1].z - m[2].y, m[2].x - m[0].z, m[0].y - m[1].x);
  float s01 = m[0].y + m[1].x, s02 = m[0].z + m[2].x, s12 = m[1].z + m[2].y;
  // Rows and columns in the order x, y, z, w.
  mat4 k = mat4(vec4(2.0 * m[0].x - trace, s01, s02, twist.x), vec4(s01, 2.0 * m[1].y - trace, s12, twist.y),
                vec4(s02, s12, 2.0 * m[2].z - trace, twist.z), vec4(twist, trace));
  // |eigenvalues of K| <= sum of the singular values of M <= sqrt(3) |M|. A little more: where all has collapsed to a point M is 0, and
  // the rotation the identity.
  float shift = 1e-6 + 1.7320508 * sqrt(dot(m[0], m[0]) + dot(m[1], m[1]) + dot(m[2], m[2]));
  k += mat4(shift);
  for (int i = 0; i < 10; ++i) {
    k *= 1.0 / (k[0].x + k[1].y + k[2].z + k[3].w);
    k = k * k;
  }
  // The longest column of what has become a projection.
  vec4 q = k[3];
  if (k[0].x > max(k[1].y, max(k[2].z, k[3].w))) q = k[0];
  else if (k[1].y > max(k[2].z, k[3].w)) q = k[1];
  else if (k[2].z > k[3].w) q = k[2];
  q *= inversesqrt(dot(q, q));
  coarse_rotation[j] = q;

  vec3 r = vec3(c0.w, c1.w, c2.w);
  vec3 cross_r = cross(-q.xyz, r);
  vec3 back = r + 2.0 * (q.w * cross_r + cross(-q.xyz, cross_r));
  coarse_gradient[3u * j] = back.x;
  coarse_gradient[3u * j + 1u] = back.y;
  coarse_gradient[3u * j + 2u] = back.z;
}
