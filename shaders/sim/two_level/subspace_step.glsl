// The step within span{z_f, z_c, p} that minimizes the quadratic model of the objective: the work of one group. The model is
// scaled by its diagonal, and its eigenvalues count by their absolute value, at least EIGENVALUE_FLOOR: a direction of
// negative curvature is descended like one of positive curvature, and a direction that depends on the others adds
// nothing. At rest, where changes of the gradient are rounding, small eigenvalues are accidental, and long steps along
// them would perturb the tissue; in motion the floor changes almost nothing. If the last step raised the objective,
// only a part of it is kept instead: up to the minimum of phi(t) = phi(0) + phi'(0) t + c t^n, but at most half. The
// exponent n follows from both values and both slopes, between 2 (an oscillation that slows down) and 4 (strained
// tissue, whose energy is of fourth order in the displacement). A step without a descending slope is discarded
// entirely, and with FINAL every step that raised the objective. Unless `remembers` is set, and in the first iteration,
// the span is that of z_f and z_c.
// In contact, with PRESSING_ROWS, the model has the rows of contact in it where they press (pressing_step.glsl). A step may
// then raise the objective as long as that stays below the highest of the last three (Grippo, Lampariello, Lucidi 1986):
// what begins to slip is not in the curvature, so that some steps raise it a little, and the next one, which knows it, finds
// more than a part of them would.
// For kernels that have declared `dot_partials`: [3 * partials] of vertices, then [curvature_count] of tets.
#include "common/finite.glsl"
#include "sim/two_level/slice_sum.glsl"
#include "sim/two_level/subspace_state.glsl"
#if !FINAL
uniform uint curvature_count;
uniform uint remembers;  // 0 or 1
#endif
INOUT(float, SubspaceState, subspace_state)
#define EIGENVALUE_FLOOR 0.03
#define ROWS_ROUNDING 1e-5       // of the rows' part in float32 sums, from which it is taken
#define OBJECTIVE_ROUNDING 2e-6  // of float32 sums of some thousand terms

// One Jacobi rotation: makes a[p][q] zero. v collects the eigenvectors in its columns.
#define ROTATE(p, q, r)                                                   \
  if (abs(a[p][q]) > 1e-20) {                                             \
    float theta = 0.5 * (a[q][q] - a[p][p]) / a[p][q];                    \
    float t = sign(theta) / (abs(theta) + sqrt(theta * theta + 1.0));     \
    if (theta == 0.0) t = 1.0;                                            \
    float c = inversesqrt(t * t + 1.0), s = t * c;                        \
    float apq = a[p][q], apr = a[p][r], aqr = a[q][r];                    \
    a[p][p] -= t * apq;                                                   \
    a[q][q] += t * apq;                                                   \
    a[p][q] = a[q][p] = 0.0;                                              \
    a[p][r] = a[r][p] = c * apr - s * aqr;                                \
    a[q][r] = a[r][q] = s * apr + c * aqr;                                \
    vec3 vp = v[p], vq = v[q];                                            \
    v[p] = c * vp - s * vq;                                               \
    v[q] = s * vp + c * vq;                                               \
  }

#if !FINAL
// The factors of z_f, z_c and p are `scale` times the unknowns of the model, which has a unit diagonal.
struct SpanModel {
  mat3 values, vectors;  // eigenvalues on the diagonal; in columns
  vec3 slope, scale;
};

// From the second derivatives along the directions, those of z_f and p as fp.
SpanModel model_of(float ff, float fc, float cc, float fp, float cp, float pp, vec3 slope) {
  vec3 diagonal = abs(vec3(ff, cc, remembers != 0u ? pp : 0.0));
  vec3 scale = vec3(diagonal.x > 0.0 ? inversesqrt(diagonal.x) : 0.0, diagonal.y > 0.0 ? inversesqrt(diagonal.y) : 0.0,
                    diagonal.z > 0.0 ? inversesqrt(diagonal.z) : 0.0);
  mat3 a = mat3(vec3(ff * scale.x * scale.x, fc * scale.x * scale.y, fp * scale.x * scale.z),
                vec3(fc * scale.x * scale.y, cc * scale.y * scale.y, cp * scale.y * scale.z),
                vec3(fp * scale.x * scale.z, cp * scale.y * scale.z, pp * scale.z * scale.z));
  mat3 v = mat3(1.0);
  for (int sweep = 0; sweep < 6; ++sweep) {
    ROTATE(0, 1, 2)
    ROTATE(0, 2, 1)
    ROTATE(1, 2, 0)
  }
  return SpanModel(a, v, slope * scale, scale);
}

float eigenvalue(SpanModel model, int k) { return max(abs(model.values[k][k]), EIGENVALUE_FLOOR); }

vec3 minimum_of(SpanModel model) {
  vec3 x = vec3(0.0);
  for (int k = 0; k < 3; ++k) x += dot(model.vectors[k], -model.slope) / eigenvalue(model, k) * model.vectors[k];
  return x;
}

#ifdef PRESSING_ROWS
#include "sim/two_level/pressing_step.glsl"
#endif
#endif

// Called by all invocations of a work group.
void solve_subspace_step(uint lane) {
  for (uint slice = lane; slice < 4u * SLICES; slice += uint(GROUP_SIZE)) {
    uint row = slice % 4u;
#if FINAL
    uint count = row == 0u ? partials : 0u;
#else
    uint count = row == 3u ? curvature_count : partials;
#endif
    sum_slice(slice, 4u, row * partials, count);
  }
#ifdef PRESSING_ROWS
  sum_rows_at_start(lane);
#endif
  barrier();
  vec3 step = vec3(0.0), last = vec3(0.0);
  bool accepted = false;
#ifdef PRESSING_ROWS
  SpanModel model;
#endif
  if (lane == 0u) {
    vec4 sums[4];
    for (uint row = 0u; row < 4u; ++row) sums[row] = sum_of_slices(row, 4u);
    float objective = sums[0].w;
    float before = subspace_state[SUBSPACE_OBJECTIVE], highest = before;
#ifdef PRESSING_ROWS
    if (remembers != 0u) highest = max(before, max(subspace_state[SUBSPACE_EARLIER], subspace_state[SUBSPACE_EARLIER + 1u]));
#endif
    // Any step from a start with an overflowing objective is accepted; an empty step cannot raise the objective, whatever
    // the rounding.
    accepted = is_finite(objective) &&
               (!is_finite(before) || objective <= highest + OBJECTIVE_ROUNDING * (abs(before) + abs(objective)));
#if !FINAL
    if (is_finite(objective) && sums[1].w == 0.0) accepted = true;
#endif
#if FINAL
    if (!accepted) step = vec3(0.0, 0.0, -1.0);
#else
    if (accepted) {
#ifdef PRESSING_ROWS
      float earlier = is_finite(before) ? before : objective;
      subspace_state[SUBSPACE_EARLIER + 1u] = remembers != 0u ? subspace_state[SUBSPACE_EARLIER] : earlier;
      subspace_state[SUBSPACE_EARLIER] = earlier;
#endif
      subspace_state[SUBSPACE_OBJECTIVE] = objective;
      vec3 slope = sums[0].xyz;
      float ff = sums[1].x + sums[3].x, fc = sums[1].y + sums[3].y, cc = sums[1].z + sums[3].z;
      float fp = sums[2].x, cp = sums[2].y, pp = sums[2].z;
#ifdef PRESSING_ROWS
      vec3 own = pressing_sums[1].xyz, mixed = pressing_sums[2].xyz, change = pressing_sums[0].xyz;
      ff = max(ff - own.x, sums[1].x) + ROWS_ROUNDING * own.x;
      cc = max(cc - own.y, sums[1].z) + ROWS_ROUNDING * own.y;
      fc -= mixed.z;
      fp -= change.x;
      cp -= change.y;
      pp += (ROWS_ROUNDING - 1.0) * change.z;
#endif
      // The elastic energy adds to the curvature of the masses; a lower value is rounding in the difference of two
      // gradients.
      pp = max(pp, sums[1].w);
      if (!is_finite(slope.y + fc + cc + cp)) slope.y = fc = cc = cp = 0.0;  // without a coarse direction that overflows
#ifdef PRESSING_ROWS
      model = model_of(ff, fc, cc, fp, cp, pp, slope);
      begin_search(model);
#else
      SpanModel model = model_of(ff, fc, cc, fp, cp, pp, slope);
      step = minimum_of(model) * model.scale;
      if (!is_finite(dot(step, step))) step = vec3(0.0);
      last = step;
#endif
    } else {
      float slope_before = sums[0].z - sums[2].z, slope = sums[0].z;  // along p, at its start and here
      float excess = objective - before - slope_before;
      float exponent = clamp((slope - slope_before) / excess, 2.0, 4.0);
      float kept = slope_before < 0.0 && is_finite(objective) ? min(0.5, pow(-slope_before / (exponent * excess), 1.0 / (exponent - 1.0))) : 0.0;
      if (!is_finite(kept) || kept < 0.0) kept = 0.0;
      step = vec3(0.0, 0.0, kept - 1.0);
      last = vec3(0.0, 0.0, kept);
#ifdef PRESSING_ROWS
      pressing_at.w = 0.0;
#endif
    }
#endif
  }
#ifdef PRESSING_ROWS
  vec3 found = least_in_span(lane, model);
  if (lane == 0u && accepted) step = last = is_finite(dot(found, found)) ? found : vec3(0.0);
#endif
  if (lane != 0u) return;
  for (uint k = 0u; k < 3u; ++k) {
    subspace_state[SUBSPACE_STEP + k] = step[k];
    subspace_state[SUBSPACE_LAST_STEP + k] = last[k];
  }
  subspace_state[SUBSPACE_ACCEPTED] = accepted ? 1.0 : 0.0;
}
