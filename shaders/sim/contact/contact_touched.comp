// Finds the vertices that have a contact point near a piece: only these gather forces. After contact_start.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(ContactBegin, contact_begin)      // [vertex_count + 1]
INPUT_UINT(ContactEntries, contact_entries)  // 4 * point + corner
INPUT_UINT(ContactNear, contact_near)        // [points]
OUTPUT(uint, ContactEnd, contact_end)        // [vertex_count] end of the entries to gather: their begin, or all

void main() {
  ITEM_OR_RETURN(v)
  uint begin = FETCH1(contact_begin, v), end = FETCH1(contact_begin, v + 1u), near = 0u;
  for (uint k = begin; k < end; ++k) near |= FETCH1(contact_near, FETCH1(contact_entries, k) / 4u);
  contact_end[v] = near != 0u ? end : begin;
}
