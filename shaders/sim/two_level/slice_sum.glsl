// Sums partials in one work group: each of SLICES invocations adds a slice of them with Kahan's correction (1965), and
// the first one adds the slices. The order is the same in every kernel that includes this file, so that the objective
// of one state always has the same bits: a difference of two orders would be mistaken for a step uphill. For kernels
// that have declared `dot_partials`.
#if SUMS_IN_GROUPS
#define SLICES 16u
#else
#define SLICES 2u  // four sums fill one vector of eight invocations on software renderers
#endif
#ifdef LAST_GROUP  // of the dispatch that stores them
#define DOT_PARTIAL(k) dot_partials[k]
#else
#define DOT_PARTIAL(k) FETCH(dot_partials, k)
#endif
#define MOST_ROWS 4u
shared vec4 slices[MOST_ROWS * SLICES];

// Slice number `slice / rows` of the row `slice % rows`, whose `count` partials begin at `first`.
void sum_slice(uint slice, uint rows, uint first, uint count) {
  precise vec4 sum = vec4(0.0), lost = vec4(0.0);
  for (uint k = slice / rows; k < count; k += SLICES) {
    precise vec4 term = DOT_PARTIAL(first + k) - lost, next = sum + term;
    lost = (next - sum) - term;
    sum = next;
  }
  slices[slice] = sum;
}

vec4 sum_of_slices(uint row, uint rows) {
  precise vec4 sum = slices[row];
  for (uint k = row + rows; k < rows * SLICES; k += rows) sum += slices[k];
  return sum;
}
