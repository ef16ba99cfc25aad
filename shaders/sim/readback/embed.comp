// Positions of embedded surface vertices, x = X + sum_a w_a u_a, after publish has written the mesh vertices (whose
// scalars are blended in the same manner). They follow the mesh vertices in the same buffer.
#include "common/io.glsl"
COMPUTE_1D
INPUT_VEC4(EmbedPosition, embed_position)    // [count] X of the surface vertex [m]
INPUT_UVEC4(EmbedVertices, embed_vertices)   // [count]
INPUT_VEC4(EmbedWeights, embed_weights)      // [count] barycentric
INPUT_VEC4(Displacement, displacement)       // [vertex_count] u [m]
#if HEAT
INPUT_UINT(PlacedVertex, placed_vertex)      // [vertex_count] index in Position of the vertex at each place
#endif
INOUT(vec4, Position, position)              // [vertex_count + count]
uniform uint vertex_count;

void main() {
  ITEM_OR_RETURN(i)
  uvec4 v = FETCH(embed_vertices, i);
  vec4 w = FETCH(embed_weights, i);
  vec3 u = w.x * FETCH(displacement, v.x).xyz + w.y * FETCH(displacement, v.y).xyz + w.z * FETCH(displacement, v.z).xyz +
           w.w * FETCH(displacement, v.w).xyz;
#if HEAT
#define SCALAR(place) position[FETCH1(placed_vertex, place)].w
  float scalar = dot(w, vec4(SCALAR(v.x), SCALAR(v.y), SCALAR(v.z), SCALAR(v.w)));
#else
  float scalar = 0.0;
#endif
  position[vertex_count + i] = vec4(FETCH(embed_position, i).xyz + u, scalar);
}
