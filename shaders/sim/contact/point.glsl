// Contact points: fixed material points of the surface (sim/contact/contact_surface.h), and after them the pairs of
// places of the tissue that may touch (sim/contact/pair_row.h).
INPUT_UVEC4(ContactVertices, contact_vertices)  // [points + pairs] the vertices, the first one free
INPUT_VEC4(ContactWeights, contact_weights)     // [points + pairs] their weights; PAIRS: whether there may be pairs
// contact_rest, [2 * points]: place at rest [m], w penalty on depth [N/m]; what float32 loses of the place [m]

// Of an array of vectors at the vertices: at a point, or between the two sides of a pair. Points have three vertices.
#define AT_POINT_OF_FACE(vectors, vertices, weights) \
  (weights.x * FETCH(vectors, vertices.x).xyz + weights.y * FETCH(vectors, vertices.y).xyz + weights.z * FETCH(vectors, vertices.z).xyz)
#if PAIRS
#define AT_POINT(vectors, vertices, weights) \
  (AT_POINT_OF_FACE(vectors, vertices, weights) + weights.w * FETCH(vectors, vertices.w).xyz)
#else
#define AT_POINT(vectors, vertices, weights) AT_POINT_OF_FACE(vectors, vertices, weights)
#endif
