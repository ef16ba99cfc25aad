// Finds the vertices that have a contact point near a piece: only these gather forces, up to the last such point. Lists
// them, in any order, behind the points (contact_list.comp). On software renderers, where invocations run in lockstep,
// those of few points have a list of their own. After contact_list.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(ContactBegin, contact_begin)       // [vertex_count + 1]
INPUT_UVEC4(ContactEntries, contact_entries)  // entry.glsl
INPUT_UINT(ContactNear, contact_near)         // [points]
OUTPUT(uint, ContactEnd, contact_end)         // [vertex_count] end of the entries to gather: their begin, or after the last near
OUTPUT(uint, ContactCounts, contact_counts)   // [stretches] 0 again, for contact_near.comp
INOUT(uint, ContactList, contact_list)        // from touched_list on: work groups, 1, 1, number of vertices; then the vertices;
                                              // with READ_TEXELS the same again from few_list on
#if READ_TEXELS
OUTPUT(vec4, ContactSums, contact_sums)  // [3 * vertex_count] 0 where nothing is near
#endif
uniform uint touched_list, few_list, stretches;
#define NEAR(entry) FETCH1(contact_near, (entry) & 0x7fffffffu)

void main() {
  ITEM_OR_RETURN(v)
  if (v < stretches) contact_counts[v] = 0u;
  uint begin = FETCH1(contact_begin, v), end = FETCH1(contact_begin, v + 1u), last = begin;
  for (uint k = begin; k < end; ++k) {
    uvec4 two = FETCH(contact_entries, k);
    if ((NEAR(two.x) | NEAR(two.z)) != 0u) last = k + 1u;
  }
  contact_end[v] = last;
  if (last > begin) {
#if READ_TEXELS
    uint list = last > begin + 1u ? touched_list : few_list;
#else
    uint list = touched_list;
#endif
    uint k = atomicAdd(contact_list[list + 3u], 1u);
    contact_list[list + 4u + k] = v;
    atomicMax(contact_list[list], k / uint(GROUP_SIZE) + 1u);
    return;
  }
#if READ_TEXELS
  for (uint k = 3u * v; k < 3u * v + 3u; ++k) contact_sums[k] = vec4(0.0);
#endif
}
