// Positions of embedded surface vertices, x = X + sum_a w_a u_a, after publish has written the mesh vertices (whose
// scalars are blended in the same manner). They follow the mesh vertices in the same buffer.
#include "common/io.glsl"
COMPUTE_1D
INPUT_VEC4(EmbedPosition, embed_position)    // [count] X of the surface vertex [m]
INPUT_UVEC4(EmbedVertices, embed_vertices)   // [count] corners
INPUT_VEC4(EmbedWeights, embed_weights)      // [count]
#if QUADRATIC
INPUT_UVEC4(EmbedMiddles, embed_middles)               // [2 * count] middles of edges, as in quadratic_tet.glsl
INPUT_VEC4(EmbedMiddleWeights, embed_middle_weights)  // [2 * count]
#endif
INPUT_VEC4(Displacement, displacement)       // [vertex_count] u [m]
#if HEAT
INPUT_UINT(PlacedVertex, placed_vertex)      // [vertex_count] index in Position of the vertex at each place
#endif
INOUT(vec4, Position, position)              // [vertex_count + count]
uniform uint vertex_count;

// xyz sum of w u, w sum of w times the scalar.
vec4 blended(uvec4 v, vec4 w) {
  vec3 u = w.x * FETCH(displacement, v.x).xyz + w.y * FETCH(displacement, v.y).xyz + w.z * FETCH(displacement, v.z).xyz +
           w.w * FETCH(displacement, v.w).xyz;
#if HEAT
#define SCALAR(place) position[FETCH1(placed_vertex, place)].w
  return vec4(u, dot(w, vec4(SCALAR(v.x), SCALAR(v.y), SCALAR(v.z), SCALAR(v.w))));
#else
  return vec4(u, 0.0);
#endif
}

void main() {
  ITEM_OR_RETURN(i)
  vec4 sum = blended(FETCH(embed_vertices, i), FETCH(embed_weights, i));
#if QUADRATIC
  sum += blended(FETCH(embed_middles, 2u * i), FETCH(embed_middle_weights, 2u * i)) +
         blended(FETCH(embed_middles, 2u * i + 1u), FETCH(embed_middle_weights, 2u * i + 1u));
#endif
  position[vertex_count + i] = vec4(FETCH(embed_position, i).xyz + sum.xyz, sum.w);
}
