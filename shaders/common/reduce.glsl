// Sums over an array, with the same result on every run: each of a fixed number of lanes adds its share of the items,
// then
//   REDUCE_TREE 1 (GPUs): the lanes of a work group are added in a tree; one partial sum per group;
//   REDUCE_TREE 0 (software renderers, where shared memory costs 20 times more): one partial sum per lane.
// The number of lanes is a multiple of GROUP_SIZE. The kernel that uses the sum adds the partials. Partials that follow
// n others are stored at i + n * PARTIAL_STRIDE.
#define REDUCE_TREE SUMS_IN_GROUPS

#if REDUCE_TREE
shared vec4 lane_sums[GROUP_SIZE];

// Called by all invocations of a group; the first one writes partials[partial].
#define STORE_PARTIAL(partials, i, sum)                                             \
  lane_sums[gl_LocalInvocationID.x] = sum;                                          \
  for (uint half_size = GROUP_SIZE / 2u; half_size > 0u; half_size /= 2u) {         \
    barrier();                                                                      \
    if (gl_LocalInvocationID.x < half_size)                                         \
      lane_sums[gl_LocalInvocationID.x] += lane_sums[gl_LocalInvocationID.x + half_size]; \
  }                                                                                 \
  if (gl_LocalInvocationID.x == 0u) partials[(i) / GROUP_SIZE] = lane_sums[0];      \
  barrier();
#define PARTIAL_STRIDE GROUP_SIZE
#else
#define STORE_PARTIAL(partials, i, sum) partials[i] = sum;
#define PARTIAL_STRIDE 1u
#endif
