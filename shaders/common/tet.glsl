// A tet's rest shape and its displacement gradient H = sum_k (u_k - u_0) b_k^T, k = 1..3.
INPUT_UVEC4(TetVertices, tet_vertices)  // [tet_count]
INPUT_VEC4(TetShape, tet_shape)         // [3 * tet_count] rows of Dm^-1: xyz gradient b_k [1/m], w of the first: volume
                                        // [m^3]; w of the others: tet_pair.glsl

struct Tet {
  uvec4 v;
  vec3 b1, b2, b3;  // b_0 = -(b1 + b2 + b3)
  float volume;
};

Tet load_tet(uint t) {
  vec4 r1 = FETCH(tet_shape, 3u * t);
  return Tet(FETCH(tet_vertices, t), r1.xyz, FETCH(tet_shape, 3u * t + 1u).xyz, FETCH(tet_shape, 3u * t + 2u).xyz, r1.w);
}

mat3 displacement_gradient(Tet tet, vec3 u0, vec3 u1, vec3 u2, vec3 u3) {
  vec3 d1 = u1 - u0, d2 = u2 - u0, d3 = u3 - u0;
  return mat3(d1 * tet.b1.x + d2 * tet.b2.x + d3 * tet.b3.x, d1 * tet.b1.y + d2 * tet.b2.y + d3 * tet.b3.y,
              d1 * tet.b1.z + d2 * tet.b2.z + d3 * tet.b3.z);
}

// det(I + H) - 1 without cancellation.
float det_f_minus_one(mat3 h) {
  return h[0].x + h[1].y + h[2].z + (h[0].x * h[1].y - h[1].x * h[0].y) + (h[1].y * h[2].z - h[2].y * h[1].z) +
         (h[0].x * h[2].z - h[2].x * h[0].z) + determinant(h);
}
