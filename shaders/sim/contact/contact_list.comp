// Lists the contact points that are near a piece, in their order, behind the pairs, which are listed; with the number of
// work groups for the kernels that process the list (common/io.glsl, DEFERRED). The list of touched vertices is empty then.
// After contact_count.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(ContactNear, contact_near)      // [points]
INPUT_UINT(ContactCounts, contact_counts)  // [stretches], and then the number of pairs
OUTPUT(uint, ContactList, contact_list)    // work groups, 1, 1, number of points; then the points; from touched_list on contact_touched.comp
uniform uint points, stretches, touched_list;

void main() {
  ITEM_OR_RETURN(i)
  uint place = FETCH1(contact_counts, stretches), end = min((i + 1u) * uint(STRETCH), points);
  for (uint k = 0u; k < i; ++k) place += FETCH1(contact_counts, k);
  if (FETCH1(contact_counts, i) != 0u)
    for (uint k = i * uint(STRETCH); k < end; ++k)
      if (FETCH1(contact_near, k) != 0u) contact_list[4u + place++] = k;
  if (i + 1u < stretches) return;
  contact_list[0] = (place + uint(GROUP_SIZE) - 1u) / uint(GROUP_SIZE);
  contact_list[1] = 1u;
  contact_list[2] = 1u;
  contact_list[3] = place;
  contact_list[touched_list] = 0u;
  contact_list[touched_list + 1u] = 1u;
  contact_list[touched_list + 2u] = 1u;
  contact_list[touched_list + 3u] = 0u;
}
