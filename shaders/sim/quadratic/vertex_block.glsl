// The 3x3 block of a vertex from the quadratic tets around it, as vertex_block computes it for linear ones. A tet's share
// takes the deformation at its centroid for all of it. With that, the means over the points of the products of shape
// gradients are, with g = grad L and b = grad N of the vertex:
//   corner a:     mean b b^T = 0.6 g_a g_a^T,  mean b = 0
//   middle ab:    mean b b^T = 1.2 s s^T + 0.4 d d^T,  mean b = s;  s = g_a + g_b, d = g_a - g_b
// and the averaged dilatation adds K (dtheta mean b)(dtheta mean b)^T. The kernel declares `displacement`.
#include "sim/quadratic/law.glsl"
INPUT_UINT(QuadraticBegin, quadratic_begin)    // [vertex_count + 1]
INPUT_UINT(VertexQuadratic, vertex_quadratic)  // [10 * quadratic_count] 10 * e + node, sorted by vertex
INPUT_VEC4(PredictedCentroid, predicted_centroid)  // [quadratic_count] w mass [kg]

struct Centroid {
  mat3 h;
  Tangent tangent;
  vec4 material;  // pointwise
  float guard;    // [Pa]
};

void add_block(inout Sym3 sum, Centroid at, float weight, vec3 b) {
  Sym3 block = corner_block(at.tangent, at.h, at.material, b);
  sum.d += weight * (block.d + at.guard * dot(b, b));
  sum.s += weight * block.s;
}

Sym3 quadratic_block(uint v) {
  Sym3 sum = Sym3(vec3(0.0), vec3(0.0));
  uint end = FETCH1(quadratic_begin, v + 1u);
  for (uint k = FETCH1(quadratic_begin, v); k < end; ++k) {
    uint entry = FETCH1(vertex_quadratic, k), e = entry / 10u, node = entry % 10u, t = FIRST_QUADRATIC + e;
    Tet tet = load_tet(t);
    vec3 g[4] = vec3[4](-(tet.b1 + tet.b2 + tet.b3), tet.b1, tet.b2, tet.b3);
    uvec4 m = FETCH(mid_edges, 2u * e), n = FETCH(mid_edges, 2u * e + 1u);
    // sum of u_ab (g_a + g_b)^T; the corners have a mean gradient of zero
    Centroid at;
    vec3 m01 = FETCH(displacement, m.x).xyz;  // differences, so that a translation costs no accuracy
    at.h = outerProduct(FETCH(displacement, m.y).xyz - m01, g[1] + g[2]) + outerProduct(FETCH(displacement, m.z).xyz - m01, g[0] + g[2]) +
           outerProduct(FETCH(displacement, m.w).xyz - m01, g[0] + g[3]) + outerProduct(FETCH(displacement, n.x).xyz - m01, g[1] + g[3]) +
           outerProduct(FETCH(displacement, n.y).xyz - m01, g[2] + g[3]);
    vec4 material = material_of(t);
    VolumeSplit split = volume_split(material);
    Dilatation dilatation = dilatation_of(at.h, material);
    VolumeTerm volume = volume_term_of(e, split.bulk, material);
    at.material = split.pointwise;
    at.tangent = elastic_tangent_of(at.h, split.pointwise);
#if BEYOND_STRAIN
    if (!IS_BEYOND_STRAIN(material))
#endif
      at.tangent.s.d += volume.bulk * dilatation.value + volume.multiplier;
    at.guard = 0.0;
#if SIGNED_ST_VENANT_KIRCHHOFF
    if (needs_guard(at.h, material)) at.guard = LEAST_STRETCH * LEAST_STRETCH * (lame_lambda(material) + 2.0 * lame_mu(material));
#endif
#if DAMPING
    Sym3 before = Sym3(vec3(0.0), vec3(0.0));
    for (int q = 0; q < 4; ++q) before.d += 0.25 * previous_strain_at(strain_of_point(e, q)).d;
    float damping = damping_over_h(before, material);
    // The viscous stiffness is that of the Green strain, of pointwise lambda 0, with its own averaged part.
    Tangent viscous = Tangent(mat3(1.0) + at.h, Sym3(vec3(0.0), vec3(0.0)), damping, 0.0);
    vec4 viscous_material = vec4(2.0 * lame_mu(material), 0.0, 0.0, 0.0);
#endif
    float scale = SUBSTEP * SUBSTEP * tet.volume;
    Sym3 block = Sym3(vec3(0.0), vec3(0.0));
    if (node < 4u) {
      add_block(block, at, 0.6, g[node]);
#if DAMPING
      Sym3 more = strain_block(viscous, viscous_material, g[node]);
      block = Sym3(block.d + 0.6 * more.d, block.s + 0.6 * more.s);
#endif
    } else {
      uvec2 ends = node == 4u ? uvec2(0, 1) : node == 5u ? uvec2(1, 2) : node == 6u ? uvec2(0, 2) : node == 7u ? uvec2(0, 3) : node == 8u ? uvec2(1, 3) : uvec2(2, 3);
      vec3 s = g[ends.x] + g[ends.y], d = g[ends.x] - g[ends.y], w = dilatation.first * s;
      add_block(block, at, 1.2, s);
      add_block(block, at, 0.4, d);
      block.d += volume.bulk * w * w;
      block.s += volume.bulk * w.yxx * w.zzy;
#if DAMPING
      Sym3 more = strain_block(viscous, viscous_material, s), other = strain_block(viscous, viscous_material, d);
      block = Sym3(block.d + 1.2 * more.d + 0.4 * other.d, block.s + 1.2 * more.s + 0.4 * other.s);
      vec3 x = viscous.f * s;
      float bulk = damping * max(viscous_lambda(material), 0.0);
      block.d += bulk * x * x;
      block.s += bulk * x.yxx * x.zzy;
#endif
    }
    float at_centroid = node < 4u ? CORNER_AT_CENTROID : MIDDLE_AT_CENTROID;
    sum.d += at_centroid * at_centroid * FETCH(predicted_centroid, e).w;
    sum.d += scale * block.d;
    sum.s += scale * block.s;
  }
  return sum;
}
