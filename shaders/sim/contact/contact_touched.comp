// Finds the vertices that have a contact point near a piece: only these gather forces, up to the last such point. Lists
// them, in any order, behind the points (contact_list.comp). On software renderers, where invocations run in lockstep,
// those of few points have a list of their own. With CROWDED also how many points share the stiffness of one there
// (sim/contact/row_stiffness.h). After contact_list.
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
#define POINT(entry) ((entry) & 0x7fffffffu)
#define NEAR(entry) FETCH1(contact_near, POINT(entry))

#if CROWDED
#include "sim/contact/piece.glsl"
INPUT_VEC4(ContactAnchor, contact_anchor)     // [rows] w of near rows, the force by which they count [N]
OUTPUT(float, ContactCrowds, contact_crowds)  // [pieces * vertex_count] of the pieces that are near

// Sum of the forces before, of their squares, and the same of those that are expected, with the weights of the point.
vec4 crowd_of(uint piece, uint entry, uint weight) {
  uint point = POINT(entry);
  if (point >= points_of(piece) || (FETCH1(contact_near, point) >> piece & 1u) == 0u) return vec4(0.0);
  float force = FETCH(contact_anchor, first_row_of(piece) + point).w;
  vec2 sums = uintBitsToFloat(weight) * vec2(abs(force), force * force);
  return force > 0.0 ? vec4(sums, 0.0, 0.0) : vec4(0.0, 0.0, sums);
}

void count_crowds(uint v, uint begin, uint end, uint near) {
  for (; near != 0u; near &= near - 1u) {
    uint piece = uint(findLSB(near));
    vec4 sums = vec4(0.0);
    for (uint k = begin; k < end; ++k) {
      uvec4 two = FETCH(contact_entries, k);
      sums += crowd_of(piece, two.x, two.y) + crowd_of(piece, two.z, two.w);
    }
    if (sums.y == 0.0) sums.xy = sums.zw;
    contact_crowds[piece * invocations + v] = sums.y > 0.0 ? sums.x * sums.x / sums.y : 0.0;
  }
}
#endif

void main() {
  ITEM_OR_RETURN(v)
  if (v < stretches) contact_counts[v] = 0u;
  uint begin = FETCH1(contact_begin, v), end = FETCH1(contact_begin, v + 1u), last = begin, near = 0u;
  for (uint k = begin; k < end; ++k) {
    uvec4 two = FETCH(contact_entries, k);
    uint pieces = NEAR(two.x) | NEAR(two.z);
    if (pieces != 0u) last = k + 1u;
    near |= pieces;
  }
  contact_end[v] = last;
#if CROWDED
  count_crowds(v, begin, last, near);
#endif
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
