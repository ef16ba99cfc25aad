// Moves a split vertex to the mean of itself and its phantoms: each moved with its share of the mass, so momentum is
// conserved. After the colors of a sweep.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(SplitVertex, split_vertex)    // [split_count] vertices that have phantoms
INPUT_UINT(CopyBegin, copy_begin)        // [vertex_count + 1] vertices and phantoms before each vertex
INOUT(vec4, Displacement, displacement)  // [vertex_count + phantom_count]
uniform uint first_item;                 // vertex_count

void main() {
  ITEM_OR_RETURN(i)
  uint v = FETCH1(split_vertex, i);
  uint begin = FETCH1(copy_begin, v), copies = FETCH1(copy_begin, v + 1u) - begin;
  uint first_phantom = first_item + begin - v;
  vec3 sum = displacement[v].xyz;
  for (uint p = 0u; p + 1u < copies; ++p) sum += displacement[first_phantom + p].xyz;
  displacement[v].xyz = sum / float(copies);
}
