// Moves every phantom to its vertex, with the vertex's inverse mass as the tets use it. Before the colors of a sweep.
#include "common/io.glsl"
COMPUTE_1D
INPUT_UINT(PhantomVertex, phantom_vertex)  // [phantom_count]
INOUT(vec4, Displacement, displacement)    // [vertex_count + phantom_count]
uniform uint first_item;                   // vertex_count

void main() {
  ITEM_OR_RETURN(i)
  displacement[first_item + i] = displacement[FETCH1(phantom_vertex, i)];
}
