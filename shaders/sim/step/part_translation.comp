// Moves a part that nothing holds to where its momentum is that of its prediction: inner forces do not change that, and
// iterations approach it only as they approach the rest. After part_sums.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(PartVertex, part_vertex)  // [vertices of such parts] sorted by part
INPUT_UINT(PartChunks, part_chunks)  // [2 * vertices of such parts] the first chunk of the vertex's part, and the end of its chunks
INPUT_VEC4(PartSums, part_sums)      // [chunks] xyz sum of m (u~ - u) [kg m], w of m [kg]
INOUT(vec4, Displacement, displacement)

void main() {
  ITEM_OR_RETURN(k)
  vec4 sum = vec4(0.0);
  for (uint chunk = FETCH1(part_chunks, 2u * k), end = FETCH1(part_chunks, 2u * k + 1u); chunk < end; ++chunk) sum += FETCH(part_sums, chunk);
  if (sum.w > 0.0) displacement[FETCH1(part_vertex, k)].xyz += sum.xyz / sum.w;
}
