// Chebyshev acceleration, second pass, one work group: the weight omega of this iteration (Wang 2015, eq. 8),
//   omega_1 = 1,  omega_2 = 2 / (2 - rho^2),  omega_{k+1} = 4 / (4 - rho^2 omega_k),
// and the spectral radius rho of the plain iteration, estimated as Hageman and Young (1981, chapter 5) do. A step
// begins with PLAIN iterations; if rho is not known yet, their last decay |f_k| / |f_{k-1}| is the first guess, which
// is always too low. An accelerated cycle of p iterations should shrink the residual to
//   Q = 1 / T_p(1 / rho) = 2 r^(p/2) / (1 + r^p),   r = (1 - s) / (1 + s),   s = sqrt(1 - rho^2);
// if it only reaches B > Q^DAMPING, rho was too low: the equation solved for rho gives a better value, and a new cycle
// begins. Safeguard: a residual that doubles within a cycle ends it; rho moves away from 1, and PLAIN iterations come
// first. After chebyshev_difference, before chebyshev_apply.
#include "common/io.glsl"
#include "common/step.glsl"
#include "sim/acceleration/chebyshev_state.glsl"
COMPUTE_1D
INPUT_VEC4(SquarePartials, square_partials)  // [partials]
INOUT(float, ChebyshevState, chebyshev_state)
uniform uint partials;
#define PLAIN 4.0
#define SHORTEST_CYCLE 4.0
#define DAMPING 0.75
#define LARGEST_RADIUS 0.9995
#define GROWTH 4.0  // of |f|^2
#define ROUNDING 1e-8  // share of the first |f|^2 below which the residual is rounding of float32

#define LANES 8u  // fixed, so that the sum is the same for any size of the work group
shared float lane_sums[LANES];

float larger_radius(float rho, float p, float b) {
  float s = sqrt(1.0 - rho * rho), r = (1.0 - s) / (1.0 + s), rp = pow(r, p);
  float q = 2.0 * sqrt(rp) / (1.0 + rp);
  if (b <= pow(q, DAMPING)) return rho;
  b = min(b, 1.0);
  float x = pow(0.5 * (1.0 + rp) * (b + sqrt(max(b * b - q * q, 0.0))), 1.0 / p);
  return min((x * x + r) / ((1.0 + r) * x), LARGEST_RADIUS);
}

void main() {
  uint lane = gl_LocalInvocationID.x;
  for (uint l = lane; l < LANES; l += uint(GROUP_SIZE)) {
    float sum = 0.0;
    for (uint p = l; p < partials; p += LANES) sum += FETCH(square_partials, p).x;
    lane_sums[l] = sum;
  }
  barrier();
  if (lane != 0u) return;
  float squared = 0.0;
  for (uint l = 0u; l < LANES; ++l) squared += lane_sums[l];

  float rho = MANUAL_SPECTRAL_RADIUS > 0.0 ? MANUAL_SPECTRAL_RADIUS : chebyshev_state[CHEBYSHEV_RADIUS];
#if FIRST_ITERATION
  float count = -PLAIN + 1.0, omega = 1.0, begin = squared;
  chebyshev_state[CHEBYSHEV_FIRST_SQUARED] = squared;
#else
  float count = chebyshev_state[CHEBYSHEV_COUNT], omega = chebyshev_state[CHEBYSHEV_WEIGHT];
  float begin = chebyshev_state[CHEBYSHEV_CYCLE_SQUARED], before = chebyshev_state[CHEBYSHEV_SQUARED];
  if (count < 0.0) {
    count += 1.0;
    if (count == 0.0) {
      if (rho == 0.0 && before > 0.0) rho = clamp(sqrt(squared / before), 0.1, LARGEST_RADIUS);
      begin = squared;
    }
  } else if (squared > GROWTH * begin) {
    count = -PLAIN + 1.0;
    rho = max(1.0 - 2.0 * (1.0 - rho), 0.1);
  } else {
    count += 1.0;
    bool telling = count >= SHORTEST_CYCLE && squared > ROUNDING * chebyshev_state[CHEBYSHEV_FIRST_SQUARED];
    float better = telling ? larger_radius(rho, count, sqrt(squared / begin)) : rho;
    if (better > rho && MANUAL_SPECTRAL_RADIUS == 0.0) {
      rho = better;
      count = 0.0;
      begin = squared;
    }
  }
  omega = count <= 0.0 ? 1.0 : count == 1.0 ? 2.0 / (2.0 - rho * rho) : 4.0 / (4.0 - rho * rho * omega);
#endif
  chebyshev_state[CHEBYSHEV_WEIGHT] = omega;
  chebyshev_state[CHEBYSHEV_RADIUS] = rho;
  chebyshev_state[CHEBYSHEV_COUNT] = count;
  chebyshev_state[CHEBYSHEV_CYCLE_SQUARED] = begin;
  chebyshev_state[CHEBYSHEV_SQUARED] = squared;
}
