// The points around a vertex: from contact_begin[v] to contact_end[v] of contact_entries, two in each uvec4, as the number
// of a point, with FIRST_CORNER at its first corner, and its weight there as bits of a float. An odd last one has
// another beside it with weight 0. For each: ADD(point, weight, whether it is the first corner).
INPUT_UINT(ContactBegin, contact_begin)       // [vertex_count + 1]
INPUT_UINT(ContactEnd, contact_end)           // [vertex_count]
INPUT_UVEC4(ContactEntries, contact_entries)
#define FIRST_CORNER 0x80000000u
#define POINT_OF(entry) ((entry) & ~FIRST_CORNER)
#define ADD_TWO(entry, ADD)                                               \
  {                                                                       \
    uvec4 two = FETCH(contact_entries, entry);                            \
    ADD(POINT_OF(two.x), uintBitsToFloat(two.y), two.x >= FIRST_CORNER)   \
    ADD(POINT_OF(two.z), uintBitsToFloat(two.w), two.z >= FIRST_CORNER)   \
  }
#define FOR_POINTS_AROUND(v, ADD)                                                                             \
  {                                                                                                           \
    uint end_of_entries = FETCH1(contact_end, v);                                                             \
    for (uint entry = FETCH1(contact_begin, v); entry < end_of_entries; ++entry) ADD_TWO(entry, ADD)          \
  }
