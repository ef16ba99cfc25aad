// The 3x3 block of a vertex in the Hessian of the step's objective, and the vertex's gradient, from the tets around it:
//   H_ii = m I + h^2 sum V corner_block(b_i), positive definite.
// The kernel declares `displacement` [vertex_count] as it reads it (AT_VERTEX(v): vec3 u).
#include "common/step.glsl"
#include "common/tet.glsl"
#include "sim/elasticity.glsl"
INPUT_UINT(SlotBegin, slot_begin)    // [vertex_count + 1]
INPUT_UINT(VertexTets, vertex_tets)  // [4 * tet_count] 4 * tet + corner, sorted by vertex

#if SIGNED_ST_VENANT_KIRCHHOFF && defined GUARDED_ELSEWHERE
// About what guarding a tet adds to its corner_block, without the singular values: as if every stretch were made larger by the least one,
// and with it the image of b, whose direction the cofactors keep while a stretch goes to zero.
Sym3 guard_estimate(Tangent tangent, mat3 h, vec4 material, vec3 b) {
  mat3 f = tangent.f;
  vec3 image = mat3(cross(f[1], f[2]), cross(f[2], f[0]), cross(f[0], f[1])) * b;
  float squared = dot(image, image), mu = lame_mu(material), size = LEAST_STRETCH * LEAST_STRETCH * dot(b, b) * tangent.stiff;
  vec3 n = squared > 0.0 ? image * inversesqrt(squared) : vec3(0.0);
  float outer = size * (lame_lambda(material) + mu);
  return Sym3(outer * n * n + size * mu, outer * n.yxx * n.zzy);
}
#endif

struct VertexBlock {
  Sym3 hessian;   // [kg]
  vec3 gradient;  // of the tets alone [kg m]
};

VertexBlock add_tets(uint v) {
  VertexBlock block = VertexBlock(Sym3(vec3(0.0), vec3(0.0)), vec3(0.0));
  uint end = FETCH1(slot_begin, v + 1u);
  for (uint k = FETCH1(slot_begin, v); k < end; ++k) {
    uint entry = FETCH1(vertex_tets, k), t = entry / 4u, corner = entry % 4u;
    Tet tet = load_tet(t);
    mat3 h = displacement_gradient(tet, AT_VERTEX(tet.v.x), AT_VERTEX(tet.v.y), AT_VERTEX(tet.v.z), AT_VERTEX(tet.v.w));
    vec3 b = corner == 0u ? -(tet.b1 + tet.b2 + tet.b3) : corner == 1u ? tet.b1 : corner == 2u ? tet.b2 : tet.b3;
    vec4 material = material_of(t);
    Tangent tangent = tangent_of(t, h, material);
    Sym3 hessian = corner_block(tangent, h, material, b);
#if SIGNED_ST_VENANT_KIRCHHOFF && defined GUARDED_ELSEWHERE
    if (needs_guard(h, material)) {
      Sym3 more = guard_estimate(tangent, h, material, b);
      hessian = Sym3(hessian.d + more.d, hessian.s + more.s);
    }
#endif
    float scale = SUBSTEP * SUBSTEP * tet.volume;
    block.hessian.d += scale * hessian.d;
    block.hessian.s += scale * hessian.s;
    block.gradient += scale * (response_of(t, h, material).p * b);
  }
  return block;
}

Sym3 inverse_of(Sym3 a) {
  Sym3 c = Sym3(vec3(a.d.y * a.d.z - a.s.x * a.s.x, a.d.x * a.d.z - a.s.y * a.s.y, a.d.x * a.d.y - a.s.z * a.s.z),
                vec3(a.s.y * a.s.z - a.d.x * a.s.x, a.s.x * a.s.z - a.d.y * a.s.y, a.s.x * a.s.y - a.d.z * a.s.z));
  float i = 1.0 / (a.d.x * c.d.x + a.s.z * c.s.z + a.s.y * c.s.y);
  return Sym3(i * c.d, i * c.s);
}
