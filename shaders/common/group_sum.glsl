// Sums for kernels with few items and a long sum for each. On GPUs a work group shares an item: each of its LANES
// invocations adds every LANES-th term, and the first one continues with the sum. On software renderers, where shared
// memory costs 20 times more, one invocation adds all terms.
#if !SUMS_IN_GROUPS
#define LANES 1u
#define SHARED_ITEM_OR_RETURN(i, lane) ITEM_OR_RETURN(i) const uint lane = 0u;
#define SUM_OVER_LANES(sum, lane)
#define SUM_FOR_ALL_LANES(sum, lane)
#else
#define LANES uint(GROUP_SIZE)
#define SHARED_ITEM_OR_RETURN(i, lane) uint i = gl_WorkGroupID.x, lane = gl_LocalInvocationID.x;
shared vec3 lane_sums[GROUP_SIZE];

// Called by all invocations of a group; afterwards only the first one's `sum` (vec3) is the sum.
#define SUM_OVER_LANES(sum, lane)                                     \
  barrier();                                                          \
  lane_sums[lane] = sum;                                              \
  for (uint other = LANES / 2u; other > 0u; other /= 2u) {            \
    barrier();                                                        \
    if (lane < other) lane_sums[lane] += lane_sums[lane + other];     \
  }                                                                   \
  sum = lane_sums[0];

// The same; afterwards it is that of every one.
#define SUM_FOR_ALL_LANES(sum, lane) \
  SUM_OVER_LANES(sum, lane)          \
  barrier();                         \
  sum = lane_sums[0];
#endif
