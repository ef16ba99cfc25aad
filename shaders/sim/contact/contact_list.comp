// Lists the contact points that are near a piece, in their order, behind the pairs, which are listed; with the number of
// work groups for the kernels that process the list (common/io.glsl, DEFERRED). The lists of touched vertices are empty then.
// After contact_near.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(ContactNear, contact_near)      // [points]
INPUT_UINT(ContactCounts, contact_counts)  // [stretches], and then the number of pairs
OUTPUT(uint, ContactList, contact_list)    // work groups, 1, 1, number of points; then the points; from touched_list on contact_touched.comp
uniform uint points, stretches, touched_list, few_list;

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
  for (uint k = 0u; k < 4u; ++k) {
    contact_list[touched_list + k] = k % 3u == 0u ? 0u : 1u;
#if READ_TEXELS
    contact_list[few_list + k] = k % 3u == 0u ? 0u : 1u;
#endif
  }
}
