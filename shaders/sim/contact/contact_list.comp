// Lists the contact points that are near a piece, in their order, one work group; with the number of work groups for
// the kernels that process the list (common/io.glsl, DEFERRED). After contact_start.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(ContactNear, contact_near)   // [points]
OUTPUT(uint, ContactList, contact_list)  // work groups, 1, 1, number of points; then the points
uniform uint points;
shared uint counts[GROUP_SIZE];

void main() {
  uint lane = gl_LocalInvocationID.x, share = (points + uint(GROUP_SIZE) - 1u) / uint(GROUP_SIZE);
  uint begin = lane * share, end = min(begin + share, points), count = 0u;
  for (uint i = begin; i < end; ++i) count += FETCH1(contact_near, i) != 0u ? 1u : 0u;
  counts[lane] = count;
  barrier();
  uint place = 4u, total = 0u;
  for (uint k = 0u; k < uint(GROUP_SIZE); ++k) {
    place += k < lane ? counts[k] : 0u;
    total += counts[k];
  }
  for (uint i = begin; i < end; ++i)
    if (FETCH1(contact_near, i) != 0u) contact_list[place++] = i;
  if (lane != 0u) return;
  contact_list[0] = (total + uint(GROUP_SIZE) - 1u) / uint(GROUP_SIZE);
  contact_list[1] = 1u;
  contact_list[2] = 1u;
  contact_list[3] = total;
}
