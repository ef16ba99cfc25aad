// Functions of the displacement gradient H = F - I that laws share. Written in H, so that small strains lose no
// accuracy to terms that cancel at rest. sim/material/invariants.h has the formulas.
#include "common/symmetric.glsl"
#include "common/tet.glsl"

// Cofactors of F, dJ/dF, minus the identity.
mat3 cofactor_minus_one(mat3 h) {
  mat3 c = mat3(h[0].x + h[1].y + h[2].z) - transpose(h);
  return c + mat3(cross(h[1], h[2]), cross(h[2], h[0]), cross(h[0], h[1]));
}

// |F|^2 - 3.
float stretch_invariant(mat3 h) {
  return 2.0 * (h[0].x + h[1].y + h[2].z) + dot(h[0], h[0]) + dot(h[1], h[1]) + dot(h[2], h[2]);
}

float inner(mat3 a, mat3 b) { return dot(a[0], b[0]) + dot(a[1], b[1]) + dot(a[2], b[2]); }

// The tensor cross product: F x A is the derivative of the cofactors along A, F : (A x B) the second one of J.
mat3 tensor_cross(mat3 a, mat3 b) {
  return mat3(cross(a[1], b[2]) + cross(b[1], a[2]), cross(a[2], b[0]) + cross(b[2], a[0]), cross(a[0], b[1]) + cross(b[0], a[1]));
}

// J - 1, tr E - (J - 1) and the sum of the principal minors of E, from the Green strain E by J^2 = det(I + 2 E). Energies
// of small strains are of second order in E. In H, of which a turn of the tet is a part, they would be differences of
// terms of second order in the turn, whose rounding is more than the energy where strains are less than a thousandth of
// the turn.
struct Growth {
  float j1, excess, minors;
};
Growth growth_of(mat3 h, Sym3 e) {
  float trace_e = trace(e), plain = det_f_minus_one(h);
  float minors = e.d.x * e.d.y + e.d.y * e.d.z + e.d.z * e.d.x - dot(e.s, e.s);
  float higher = 4.0 * minors + 8.0 * (e.d.x * e.d.y * e.d.z + 2.0 * e.s.x * e.s.y * e.s.z - dot(e.d, e.s * e.s));
  float squared = 2.0 * trace_e + higher;  // J^2 - 1
  if (!(plain > -0.5) || !(squared > -0.9)) return Growth(plain, trace_e - plain, minors);
  float j1 = squared / (1.0 + sqrt(1.0 + squared));
  return Growth(j1, (trace_e * j1 - higher) / (2.0 + j1), minors);
}

// x - log(1 + x).
float above_logarithm(float x) {
  if (abs(x) > 0.1) return x - log(1.0 + x);
  return x * x * (0.5 + x * (-1.0 / 3.0 + x * (0.25 + x * (-0.2 + x * (1.0 / 6.0 - x / 7.0)))));
}

// A function of J with its first and second derivative.
struct OfVolume {
  float value, first, second;
};

// J - 1 - l(J), where l is the logarithm, continued as a parabola below J = least; j1 = J - 1.
#define LEAST_VOLUME_RATIO 0.2
OfVolume above_extended_log(float j1, float least) {
  float j = 1.0 + j1;
  if (j >= least) return OfVolume(above_logarithm(j1), j1 / j, 1.0 / (j * j));
  float y = (j - least) / least;
  return OfVolume(j1 - (log(least) + y - 0.5 * y * y), 1.0 - (1.0 - y) / least, 1.0 / (least * least));
}

// k (J - 1)^2 / 2; k (log J)^2 / 2 if k < 0 and J > 1.
OfVolume volume_term(float j1, float k) {
  if (k >= 0.0 || j1 <= 0.0) return OfVolume(0.5 * k * j1 * j1, k * j1, k);
  float logarithm = j1 - above_logarithm(j1), j = 1.0 + j1;
  return OfVolume(0.5 * k * logarithm * logarithm, k * logarithm / j, k * (1.0 - logarithm) / (j * j));
}
