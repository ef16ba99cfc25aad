// Solves a symmetric positive definite 6x6 system by LDL^T; `a` is the lower triangle by rows:
// a[0]; a[1] a[2]; a[3] a[4] a[5]; ... The right-hand side is replaced by the solution.
#define LOWER(i, j) ((i) * ((i) + 1) / 2 + (j))

void solve6(inout float a[21], inout float x[6]) {
  for (int j = 0; j < 6; ++j) {
    float d = a[LOWER(j, j)];
    for (int k = 0; k < j; ++k) d -= a[LOWER(j, k)] * a[LOWER(j, k)] * a[LOWER(k, k)];
    a[LOWER(j, j)] = d;
    float inv_d = 1.0 / d;
    for (int i = j + 1; i < 6; ++i) {
      float l = a[LOWER(i, j)];
      for (int k = 0; k < j; ++k) l -= a[LOWER(i, k)] * a[LOWER(j, k)] * a[LOWER(k, k)];
      a[LOWER(i, j)] = l * inv_d;
    }
  }
  for (int i = 1; i < 6; ++i)
    for (int k = 0; k < i; ++k) x[i] -= a[LOWER(i, k)] * x[k];
  for (int i = 0; i < 6; ++i) x[i] /= a[LOWER(i, i)];
  for (int i = 4; i >= 0; --i)
    for (int k = i + 1; k < 6; ++k) x[i] -= a[LOWER(k, i)] * x[k];
}
