// The forces of a cluster: 64 pairs of tets (common/tet_pair.glsl), one for each invocation of a work group, are summed
// for each of the cluster's vertices in shared memory, in a fixed order, and stored in a slot of the vertex. With LISTED
// only the listed pairs count. Lists: sim/gpu/passes/force_clusters.h.
INPUT_UINT(Clusters, clusters)        // [clusters] where the list of each begins: the number n of its vertices; n times
                                      // the slot and first + 65536 * number of the vertex's corners among the following;
                                      // all corners, 64 * corner + pair, three in each number
OUTPUT(vec4, Correction, correction)  // [slots]
uniform uint pair_and_single_count;
#define CORNERS (5 * GROUP_SIZE)
shared float corner_x[CORNERS], corner_y[CORNERS], corner_z[CORNERS], pair_energy[GROUP_SIZE];

uint cluster_of_group() {
#ifdef LISTED
  return FETCH1(item_list, 3u * gl_WorkGroupID.x);
#else
  return gl_WorkGroupID.x;
#endif
}

// Whether the invocation's pair exists and counts.
bool pair_counts(uint pair, uint lane) {
#ifdef LISTED
  return (FETCH1(item_list, 3u * gl_WorkGroupID.x + 1u + lane / 32u) >> (lane % 32u) & 1u) != 0u;
#else
  return pair < pair_and_single_count;
#endif
}

void keep_corner(uint corner, uint lane, vec3 force) {
  uint at = uint(GROUP_SIZE) * corner + lane;
  corner_x[at] = force.x;
  corner_y[at] = force.y;
  corner_z[at] = force.z;
}

// Called by all invocations of a group after the corners of all its pairs are kept.
void store_cluster(uint cluster, uint lane) {
  barrier();
  uint list = FETCH1(clusters, cluster), vertices = FETCH1(clusters, list), corners = list + 1u + 2u * vertices;
  for (uint v = lane; v < vertices; v += uint(GROUP_SIZE)) {
    uint slot = FETCH1(clusters, list + 1u + 2u * v), range = FETCH1(clusters, list + 2u + 2u * v);
    vec4 sum = vec4(0.0);
    for (uint k = range & 0xffffu, end = k + (range >> 16u); k < end; ++k) {
      uint at = FETCH1(clusters, corners + k / 3u) >> 10u * (k % 3u) & 0x3ffu;
      sum += vec4(corner_x[at], corner_y[at], corner_z[at], at < uint(GROUP_SIZE) ? pair_energy[at] : 0.0);
    }
    correction[slot] = sum;
  }
}
