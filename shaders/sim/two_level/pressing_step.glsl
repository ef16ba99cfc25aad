// The step of the subspace where contact begins or ceases to press within it, in which the model of subspace_step.glsl is off: the
// work of one group, whose invocations share the rows. Of row r of contact the objective has y^2/2 where y > 0, with
//   y = contact_along[r].w - dot(contact_along[r].xyz, s)
// at factors s of z_f, z_c and p. What remains of the model without the rows is quadratic; with them it is convex and piecewise quadratic,
// and Newton's method (Qi, Sun 1993) finds the minimum: the first step is that of the whole quadratic model, the next ones know what presses
// where it leads. The lowest place of all passes is the result. Of a search that has found none, whose steps go in circles, the last ones are
// cut back to s = 0.
INPUT_VEC4(ContactAlong, contact_along)  // [rows] [kg^1/2 m]
INPUT_UINT(ContactList, contact_list)    // their number in [3]
#define MOST_PRESSING_PASSES 6u  // sim/gpu/contact/contact_passes.cpp
// Slices of the rows, whose number is not that of invocations: sums have the same bits in a fused program.
#define PRESSING_SLICES 64u
shared vec4 pressing_sums[3u * PRESSING_SLICES];
shared vec4 pressing_at;  // xyz factors to look at, w 0 when the search has ended

// What the rows do at s, against s = 0, summed.
struct PressingSums {
  float energy;   // y^2/2, less what it and its slope at 0 give
  vec3 slope;     // of that
  vec3 own, mixed;  // second derivatives of y^2/2: ff, cc, pp and cp, fp, fc
};

void add_curvature(inout PressingSums sums, vec4 row) {
  sums.own += row.xyz * row.xyz;
  sums.mixed += row.yxx * row.zzy;
}

void add_row(inout PressingSums sums, vec4 row, vec3 s) {
  float change = dot(row.xyz, s), y = row.w - change;
  if (y > 0.0) add_curvature(sums, row);
  // Differences are taken row by row: most of what rows bear balances the tissue.
  if (row.w > 0.0) {
    float less = y > 0.0 ? change : row.w;
    sums.energy += y > 0.0 ? 0.5 * change * change : row.w * (change - 0.5 * row.w);
    sums.slope += less * row.xyz;
  } else if (y > 0.0) {
    sums.energy += 0.5 * y * y;
    sums.slope -= y * row.xyz;
  }
}

// Row k, or one that never presses. Eight of a slice at a time: software renderers bound the number of loops.
vec4 along_of(uint k, uint rows) {
  vec4 row = FETCH(contact_along, min(k, rows - 1u));
  return k < rows ? row : vec4(0.0, 0.0, 0.0, -1.0);
}
#define FOR_ROWS_OF_SLICE(k, slice, rows, f)                             \
  for (uint k = slice; k < rows; k += 8u * PRESSING_SLICES) {            \
    f(k) f(k + PRESSING_SLICES) f(k + 2u * PRESSING_SLICES) f(k + 3u * PRESSING_SLICES)                       \
    f(k + 4u * PRESSING_SLICES) f(k + 5u * PRESSING_SLICES) f(k + 6u * PRESSING_SLICES) f(k + 7u * PRESSING_SLICES) \
  }

void add_row_at_start(inout PressingSums sums, vec4 row) {
  if (row.w > 0.0) add_curvature(sums, row);
  sums.slope += (max(row.w + row.z, 0.0) - max(row.w, 0.0)) * row.xyz;
}

void store_slice(uint slice, PressingSums sums) {
  pressing_sums[slice] = vec4(sums.slope, sums.energy);
  pressing_sums[PRESSING_SLICES + slice] = vec4(sums.own, 0.0);
  pressing_sums[2u * PRESSING_SLICES + slice] = vec4(sums.mixed, 0.0);
}

// Called by all invocations of the group, after store_slice() for all slices: leaves the sums in pressing_sums[0] to [2].
void sum_slices(uint lane) {
  barrier();
  vec4 sum = vec4(0.0);
  if (lane < 3u)
    for (uint k = 0u; k < PRESSING_SLICES; ++k) sum += pressing_sums[lane * PRESSING_SLICES + k];
  barrier();
  if (lane < 3u) pressing_sums[lane] = sum;
  barrier();
}

// The second derivatives at s = 0, and as `slope` what the change of the gradient over the last step has of the rows.
void sum_rows_at_start(uint lane) {
  uint rows = FETCH1(contact_list, 3u);
  for (uint slice = lane; slice < PRESSING_SLICES; slice += uint(GROUP_SIZE)) {
    PressingSums sums = PressingSums(0.0, vec3(0.0), vec3(0.0), vec3(0.0));
#define ADD(row) add_row_at_start(sums, along_of(row, rows));
    FOR_ROWS_OF_SLICE(k, slice, rows, ADD)
#undef ADD
    store_slice(slice, sums);
  }
  sum_slices(lane);
}

void sum_rows(uint lane, vec3 s) {
  uint rows = FETCH1(contact_list, 3u);
  for (uint slice = lane; slice < PRESSING_SLICES; slice += uint(GROUP_SIZE)) {
    PressingSums sums = PressingSums(0.0, vec3(0.0), vec3(0.0), vec3(0.0));
#define ADD(row) add_row(sums, along_of(row, rows), s);
    FOR_ROWS_OF_SLICE(k, slice, rows, ADD)
#undef ADD
    store_slice(slice, sums);
  }
  sum_slices(lane);
}

mat3 quadratic_part(SpanModel model) {
  mat3 sum = mat3(0.0);
  for (int k = 0; k < 3; ++k) sum += eigenvalue(model, k) * outerProduct(model.vectors[k], model.vectors[k]);
  return sum;
}

// With the second derivatives of the rows that were summed.
mat3 with_rows(mat3 quadratic, vec3 scale) {
  vec3 own = pressing_sums[1].xyz * scale * scale, mixed = pressing_sums[2].xyz * scale.yxx * scale.zzy;
  return quadratic + mat3(vec3(own.x, mixed.z, mixed.y), vec3(mixed.z, own.y, mixed.x), vec3(mixed.y, mixed.x, own.z));
}

// The solution of a symmetric positive definite system, by Cholesky's factors.
vec3 solved(mat3 a, vec3 b) {
  float l00 = sqrt(a[0][0]), l10 = a[0][1] / l00, l20 = a[0][2] / l00;
  float l11 = sqrt(max(a[1][1] - l10 * l10, 1e-7 * a[1][1])), l21 = (a[1][2] - l20 * l10) / l11;
  float l22 = sqrt(max(a[2][2] - l20 * l20 - l21 * l21, 1e-7 * a[2][2]));
  float y0 = b.x / l00, y1 = (b.y - l10 * y0) / l11, y2 = (b.z - l20 * y0 - l21 * y1) / l22;
  float x2 = y2 / l22, x1 = (y1 - l21 * x2) / l11;
  return vec3((y0 - l10 * x1 - l20 * x2) / l00, x1, x2);
}

// By the first invocation, after sum_rows_at_start().
void begin_search(SpanModel model) {
  vec3 x = solved(with_rows(quadratic_part(model), model.scale), -model.slope);
  pressing_at = vec4(x * model.scale, 1.0);
}

// Called by all invocations of the group; the factors, for the first one.
vec3 least_in_span(uint lane, SpanModel model) {
  const float kEnough = 1e-4;  // of the decrease that was found
  vec3 best = vec3(0.0);
  float least = 0.0;
  mat3 quadratic;
  if (lane == 0u) quadratic = quadratic_part(model);
  for (uint pass = 0u; pass < MOST_PRESSING_PASSES; ++pass) {
    barrier();
    vec4 at = pressing_at;
    if (at.w == 0.0) break;
    sum_rows(lane, at.xyz);
    if (lane == 0u) {
      vec3 x = vec3(0.0);
      for (int k = 0; k < 3; ++k)
        if (model.scale[k] > 0.0) x[k] = at[k] / model.scale[k];
      vec3 pull = quadratic * x, slope = model.slope + pull + model.scale * pressing_sums[0].xyz;
      float energy = dot(model.slope + 0.5 * pull, x) + pressing_sums[0].w;
      vec3 next = solved(with_rows(quadratic, model.scale), -slope);
      if (energy < least) {
        best = at.xyz;
        least = energy;
        if (-dot(next, slope) <= -kEnough * least) pressing_at.w = 0.0;
      }
      bool in_circles = least == 0.0 && pass > 3u;
      pressing_at.xyz = in_circles ? 0.25 * at.xyz : at.xyz + next * model.scale;
    }
  }
  return best;
}
