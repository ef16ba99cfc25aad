// Counts the contact points that are near a piece, a stretch of STRETCH points in each invocation. After contact_start.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(ContactNear, contact_near)      // [points]
OUTPUT(uint, ContactCounts, contact_counts)  // [stretches]
uniform uint points;

void main() {
  ITEM_OR_RETURN(i)
  uint end = min((i + 1u) * uint(STRETCH), points), count = 0u;
  for (uint k = i * uint(STRETCH); k < end; ++k) count += FETCH1(contact_near, k) != 0u ? 1u : 0u;
  contact_counts[i] = count;
}
