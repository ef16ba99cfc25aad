// What the iterations missed of the motion of parts that nothing holds: sums of m (u~ - u) over chunks of their vertices.
// Before part_translation, which adds up the chunks of a part. On GPUs a work group takes a chunk.
#include "common/io.glsl"
#include "common/reduce.glsl"
COMPUTE_1D
INPUT_UINT(PartVertex, part_vertex)     // [vertices of such parts] sorted by part
INPUT_UINT(ChunkBegin, chunk_begin)     // [chunks + 1] in part_vertex
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]
INPUT_VEC4(Predicted, predicted)        // [vertex_count] u~ [m]
INPUT_FLOAT(Mass, mass)                 // [vertex_count] lumped [kg]
OUTPUT(vec4, PartSums, part_sums)       // [chunks] xyz sum of m (u~ - u) [kg m], w of m [kg]
#if SUMS_IN_GROUPS
#define LANES uint(GROUP_SIZE)
#else
#define LANES 1u
#endif

void main() {
  LANE_OR_RETURN(i)
  uint chunk = i / LANES, end = FETCH1(chunk_begin, chunk + 1u);
  vec4 sum = vec4(0.0);
  for (uint k = FETCH1(chunk_begin, chunk) + i % LANES; k < end; k += LANES) {
    uint v = FETCH1(part_vertex, k);
    sum += FETCH1(mass, v) * vec4(FETCH(predicted, v).xyz - FETCH(displacement, v).xyz, 1.0);
  }
  STORE_PARTIAL(part_sums, i, sum)
}
