// Finds the vertices that have a contact point near a piece: only these gather forces. Lists them, in any order, behind
// the points (contact_list.comp). After contact_list.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(ContactBegin, contact_begin)       // [vertex_count + 1]
INPUT_UVEC4(ContactEntries, contact_entries)  // entry.glsl
INPUT_UINT(ContactNear, contact_near)         // [points]
OUTPUT(uint, ContactEnd, contact_end)         // [vertex_count] end of the entries to gather: their begin, or all
INOUT(uint, ContactList, contact_list)        // from touched_list on: work groups, 1, 1, number of vertices; then the vertices
#if READ_TEXELS
OUTPUT(vec4, ContactSums, contact_sums)  // [3 * vertex_count] 0 where nothing is near
#endif
uniform uint touched_list;
#define NEAR(entry) FETCH1(contact_near, (entry) & 0x7fffffffu)

void main() {
  ITEM_OR_RETURN(v)
  uint begin = FETCH1(contact_begin, v), end = FETCH1(contact_begin, v + 1u), near = 0u;
  for (uint k = begin; k < end; ++k) {
    uvec4 two = FETCH(contact_entries, k);
    near |= NEAR(two.x) | NEAR(two.z);
  }
  contact_end[v] = near != 0u ? end : begin;
  if (near != 0u) {
    uint k = atomicAdd(contact_list[touched_list + 3u], 1u);
    contact_list[touched_list + 4u + k] = v;
    atomicMax(contact_list[touched_list], k / uint(GROUP_SIZE) + 1u);
    return;
  }
#if READ_TEXELS
  for (uint k = 3u * v; k < 3u * v + 3u; ++k) contact_sums[k] = vec4(0.0);
#endif
}
