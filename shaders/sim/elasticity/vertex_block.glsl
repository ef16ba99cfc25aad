// The 3x3 block of a vertex in the Hessian of the step's objective, and the vertex's gradient, from the linear tets
// around it:
//   H_ii = m I + h^2 sum V corner_block(b_i), positive definite.
// The kernel declares its own access to `displacement` [vertex_count] (AT_VERTEX(v): vec3 u). GUARDED_ELSEWHERE: blocks
// that are only a preconditioner omit the decomposition of guarded tets. The guard adds at most LEAST_STRETCH^2 I to F
// F^T.
#include "common/step.glsl"
#include "common/tet.glsl"
#include "sim/elasticity/elasticity.glsl"
INPUT_UINT(TetBegin, tet_begin)      // [vertex_count + 1]
INPUT_UINT(VertexTets, vertex_tets)  // [4 * tet_count] 4 * tet + corner, sorted by vertex

struct VertexBlock {
  Sym3 hessian;   // [kg]
  vec3 gradient;  // of the tets only [kg m]
  bool guard;     // with DEFERS: whether a tet needs the guard
};

VertexBlock add_tets(uint v) {
  VertexBlock block = VertexBlock(Sym3(vec3(0.0), vec3(0.0)), vec3(0.0), false);
  uint end = FETCH1(tet_begin, v + 1u);
  for (uint k = FETCH1(tet_begin, v); k < end; ++k) {
    uint entry = FETCH1(vertex_tets, k), t = entry / 4u, corner = entry % 4u;
    Tet tet = load_tet(t);
    mat3 h = displacement_gradient(tet, AT_VERTEX(tet.v.x), AT_VERTEX(tet.v.y), AT_VERTEX(tet.v.z), AT_VERTEX(tet.v.w));
    vec3 b = corner == 0u ? -(tet.b1 + tet.b2 + tet.b3) : corner == 1u ? tet.b1 : corner == 2u ? tet.b2 : tet.b3;
    vec4 material = material_of(t);
#ifdef DEFERS
    block.guard = block.guard || needs_guard(h, material);
#endif
    Tangent tangent = tangent_of(t, h, material);
    Sym3 hessian = corner_block(tangent, h, material, b);
#if SIGNED_ST_VENANT_KIRCHHOFF && defined GUARDED_ELSEWHERE
    if (needs_guard(h, material))
      hessian.d += LEAST_STRETCH * LEAST_STRETCH * (lame_lambda(material) + 2.0 * lame_mu(material)) * dot(b, b);
#endif
    float scale = SUBSTEP * SUBSTEP * tet.volume;
    block.hessian.d += scale * hessian.d;
    block.hessian.s += scale * hessian.s;
#if DAMPING || BEYOND_STRAIN
    block.gradient += scale * (response_of(t, h, material).p * b);
#else
    block.gradient += scale * (times(tangent.f, tangent.s) * b);
#endif
  }
  return block;
}
