// Contact points: fixed material points of the surface (sim/contact/contact_surface.h).
INPUT_UVEC4(ContactVertices, contact_vertices)  // [points] xyz the vertices, the first one free
INPUT_VEC4(ContactWeights, contact_weights)     // [points] xyz their weights, w the penalty at level 0 [N/m]

// Of an array of vectors at the vertices, at point i.
#define AT_POINT(vectors, vertices, weights) \
  (weights.x * FETCH(vectors, vertices.x).xyz + weights.y * FETCH(vectors, vertices.y).xyz + weights.z * FETCH(vectors, vertices.z).xyz)
