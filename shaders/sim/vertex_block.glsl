// The 3x3 block of a vertex in the Hessian of the step's objective, and the vertex's gradient, from the tets around it:
//   H_ii = m I + h^2 sum V [ max(0, b.Sb) I + (1 + g) ((lambda + mu) (F b)(F b)^T + mu |b|^2 F F^T) ],   g = damping / h.
// The geometric term b.Sb is the only one that can be negative; without its negative part the block is positive definite.
// The kernel declares `displacement` [vertex_count] as it reads it (AT_VERTEX(v): vec3 u).
#include "common/step.glsl"
#include "common/symmetric.glsl"
#include "common/tet.glsl"
#include "sim/feature_material.glsl"
#include "sim/feature_damping.glsl"
#include "sim/material/st_venant_kirchhoff.glsl"
INPUT_UINT(SlotBegin, slot_begin)    // [vertex_count + 1]
INPUT_UINT(VertexTets, vertex_tets)  // [4 * tet_count] 4 * tet + corner, sorted by vertex

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
    mat3 f = mat3(1.0) + h;
    vec3 b = corner == 0u ? -(tet.b1 + tet.b2 + tet.b3) : corner == 1u ? tet.b1 : corner == 2u ? tet.b2 : tet.b3;
    Sym3 e = green_strain(h);
    vec4 material = material_of(t);
    float damping = damping_over_h(material);
    Sym3 before = previous_strain_of(t);
    Sym3 s = second_piola_stress(Sym3(e.d + damping * (e.d - before.d), e.s + damping * (e.s - before.s)), material);
    float scale = SUBSTEP * SUBSTEP * tet.volume;
    float mu = lame_mu(material), stiff = scale * (1.0 + damping);
    vec3 sb = times(s, b), fb = f * b;
    vec3 r0 = vec3(f[0].x, f[1].x, f[2].x), r1 = vec3(f[0].y, f[1].y, f[2].y), r2 = vec3(f[0].z, f[1].z, f[2].z);
    float outer = stiff * (lame_lambda(material) + mu), inner = stiff * mu * dot(b, b);
    block.hessian.d += outer * fb * fb + inner * vec3(dot(r0, r0), dot(r1, r1), dot(r2, r2)) + scale * max(0.0, dot(b, sb));
    block.hessian.s += outer * fb.yxx * fb.zzy + inner * vec3(dot(r1, r2), dot(r0, r2), dot(r0, r1));
    block.gradient += scale * (f * sb);
  }
  return block;
}

Sym3 inverse_of(Sym3 a) {
  Sym3 c = Sym3(vec3(a.d.y * a.d.z - a.s.x * a.s.x, a.d.x * a.d.z - a.s.y * a.s.y, a.d.x * a.d.y - a.s.z * a.s.z),
                vec3(a.s.y * a.s.z - a.d.x * a.s.x, a.s.x * a.s.z - a.d.y * a.s.y, a.s.x * a.s.y - a.d.z * a.s.z));
  float i = 1.0 / (a.d.x * c.d.x + a.s.z * c.s.z + a.s.y * c.s.y);
  return Sym3(i * c.d, i * c.s);
}
