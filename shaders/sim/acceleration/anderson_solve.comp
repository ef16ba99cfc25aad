// Anderson acceleration, third pass, one work group: theta = argmin |f_k - dF theta|^2 by the normal equations, scaled
// to a unit diagonal. REGULARIZATION keeps columns that float32 cannot distinguish from canceling each other.
// When |f|^2 has grown fourfold the history misleads, and when |f| is as small as the rounding of G it is noise: it is
// forgotten, and the iteration is a plain one.
// After anderson_dots, before anderson_apply.
#include "common/io.glsl"
#include "common/finite.glsl"
#include "sim/acceleration/anderson_state.glsl"
COMPUTE_1D
INPUT_VEC4(DotPartials, dot_partials)  // [parts * window * partials]
INOUT(float, AndersonState, anderson_state)
uniform uint window, partials, parts;  // partials of one column of one part
#define LARGEST_WINDOW 10
#define REGULARIZATION 1e-6
#define ROUNDING 3e-7  // relative, of a sweep in float32

shared vec4 dots[LARGEST_WINDOW];
// Arrays with variable indices: private ones are in a GPU's slowest memory, shared ones in llvmpipe's.
#if !READ_TEXELS
shared float factor[LARGEST_WINDOW][LARGEST_WINDOW], theta[LARGEST_WINDOW], scale[LARGEST_WINDOW];
#endif

void main() {
  uint lane = gl_LocalInvocationID.x;
  for (uint column = lane; column < window; column += GROUP_SIZE) {
    vec4 sum = vec4(0.0);
    for (uint part = 0u; part < parts; ++part)
      for (uint p = 0u; p < partials; ++p) sum += FETCH(dot_partials, (part * window + column) * partials + p);
    dots[column] = sum;
  }
  barrier();
  if (lane != 0u) return;

  uint newest = uint(anderson_state[ANDERSON_NEXT]);
  uint count = min(uint(anderson_state[ANDERSON_COUNT]) + 1u, window);
  float squared = dots[0].z;
  bool misled = !is_finite(squared) || squared > 4.0 * anderson_state[ANDERSON_SQUARED] || squared < ROUNDING * ROUNDING * dots[0].w;
  anderson_state[ANDERSON_SQUARED] = squared;
  if (misled) {
    anderson_state[ANDERSON_NEXT] = 0.0;
    anderson_state[ANDERSON_COUNT] = 0.0;
    return;
  }
  anderson_state[ANDERSON_NEXT] = float((newest + 1u) % window);
  anderson_state[ANDERSON_COUNT] = float(count);

  // Columns are used from slot 0 on, so the first `count` slots are filled.
#if READ_TEXELS
  float factor[LARGEST_WINDOW][LARGEST_WINDOW], theta[LARGEST_WINDOW], scale[LARGEST_WINDOW];
#endif
  for (uint j = 0u; j < count; ++j) {
    anderson_state[ANDERSON_GRAM + newest * window + j] = dots[j].x;
    anderson_state[ANDERSON_GRAM + j * window + newest] = dots[j].x;
  }
  for (uint j = 0u; j < count; ++j) {
    float diagonal = anderson_state[ANDERSON_GRAM + j * window + j];
    scale[j] = diagonal > 0.0 ? inversesqrt(diagonal) : 0.0;
    theta[j] = scale[j] * dots[j].y;
  }
  for (uint j = 0u; j < count; ++j) {
    for (uint k = 0u; k < j; ++k) factor[j][k] = scale[j] * scale[k] * anderson_state[ANDERSON_GRAM + j * window + k];
    factor[j][j] = 1.0 + REGULARIZATION;
  }
  // Cholesky: factor becomes L, then theta the solution.
  for (uint j = 0u; j < count; ++j) {
    for (uint k = 0u; k < j; ++k) {
      for (uint l = 0u; l < k; ++l) factor[j][k] -= factor[j][l] * factor[k][l];
      factor[j][k] /= factor[k][k];
      factor[j][j] -= factor[j][k] * factor[j][k];
    }
    factor[j][j] = sqrt(max(factor[j][j], REGULARIZATION));
    for (uint k = 0u; k < j; ++k) theta[j] -= factor[j][k] * theta[k];
    theta[j] /= factor[j][j];
  }
  bool finite = true;
  for (uint j = count; j-- > 0u;) {
    for (uint k = j + 1u; k < count; ++k) theta[j] -= factor[k][j] * theta[k];
    theta[j] /= factor[j][j];
    float weight = scale[j] * theta[j];
    anderson_state[ANDERSON_WEIGHTS + j] = weight;
    finite = finite && is_finite(weight);
  }
  if (!finite) {
    anderson_state[ANDERSON_NEXT] = 0.0;
    anderson_state[ANDERSON_COUNT] = 0.0;
  }
}
