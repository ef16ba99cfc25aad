// Singular values of a 3x3 matrix with proper rotations: F = U diag(s) V^T, det U = det V = 1, |s| descending, so that
// the last one carries the sign of det F (Irving, Teran, Fedkiw 2004). Computed by one-sided Jacobi rotations (Hestenes
// 1958): the columns of F V become orthogonal, small values keep their relative accuracy, and equal or zero ones need
// no special case. The loop contains one rotation and permutes the columns: if no invocation of a group in lockstep
// needs the result, the group executes one of the 15.
struct Svd {
  mat3 u, v;
  vec3 s;
};

// The longer column first; the sign keeps the rotation proper.
#define SORT(p, q)                                \
  if (dot(b[p], b[p]) < dot(b[q], b[q])) {        \
    vec3 bp = b[p], vp = v[p];                    \
    b[p] = b[q];                                  \
    b[q] = -bp;                                   \
    v[p] = v[q];                                  \
    v[q] = -vp;                                   \
  }

vec3 perpendicular(vec3 a) {
  vec3 least = abs(a.x) < abs(a.y) ? (abs(a.x) < abs(a.z) ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, 1.0))
                                   : (abs(a.y) < abs(a.z) ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0));
  return normalize(cross(a, least));
}

Svd signed_svd(mat3 f, bool wanted) {
  vec3 largest = max(abs(f[0]), max(abs(f[1]), abs(f[2])));
  float size = max(largest.x, max(largest.y, largest.z));
  mat3 b = size > 0.0 ? f * (1.0 / size) : mat3(0.0), v = mat3(1.0);
  for (int left = wanted ? 15 : 0; left > 0; --left) {  // five for every pair of columns
    float pp = dot(b[0], b[0]), qq = dot(b[1], b[1]), pq = dot(b[0], b[1]);
    float zeta = 0.5 * (qq - pp) / pq;
    float t = (zeta >= 0.0 ? 1.0 : -1.0) / (abs(zeta) + sqrt(1.0 + zeta * zeta));
    float c = inversesqrt(1.0 + t * t), s = c * t;
    if (!(abs(pq) > 1e-8 * sqrt(pp) * sqrt(qq))) c = 1.0, s = 0.0;
    vec3 b1 = s * b[0] + c * b[1], v1 = s * v[0] + c * v[1];
    b = mat3(b1, b[2], c * b[0] - s * b[1]);
    v = mat3(v1, v[2], c * v[0] - s * v[1]);
  }
  SORT(0, 1)
  SORT(0, 2)
  SORT(1, 2)
  float first = length(b[0]);
  vec3 u0 = first > 0.0 ? b[0] / first : vec3(1.0, 0.0, 0.0);
  vec3 rest = b[1] - dot(b[1], u0) * u0;
  float second = length(rest);
  vec3 u1 = second > 1e-6 * first ? rest / second : perpendicular(u0);
  if (dot(u1, b[1]) < 0.0) u1 = -u1;
  vec3 u2 = cross(u0, u1);
  return Svd(mat3(u0, u1, u2), v, size * vec3(first, dot(u1, b[1]), dot(u2, b[2])));
}
