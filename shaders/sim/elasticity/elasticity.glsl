// The elastic and viscous response of a tet with displacement gradient H: energy, first Piola stress and their
// linearization.
//   laws of the Green strain: P = F S, S = D : e, with F and e as returned by deformation_of()
//   other laws: sim/material/laws.glsl
//   viscous, of every model (Kelvin-Voigt): P = damping/h F D : (E - E_n) of the plain Green strain E
//   (damping_share() in sim/material/law.h: laws that reduce it where a tet is drawn out; viscous_lambda() there)
#include "sim/material/deformation.glsl"
#include "sim/elasticity/feature_damping.glsl"
#include "sim/material/st_venant_kirchhoff.glsl"

struct Elastic {
  mat3 p;        // first Piola stress dPsi/dF [Pa]
  float energy;  // density Psi [J/m^3]
};

#if BEYOND_STRAIN
#include "sim/material/laws.glsl"
#endif

// Of the laws of the Green strain.
Elastic strain_response(Deformation d, vec4 material) {
  Sym3 s = second_piola_stress(d.e, material);
  return Elastic(times(d.f, s), 0.5 * contract(s, d.e));
}

Elastic elastic_of(mat3 h, vec4 material) {
#if BEYOND_STRAIN
  if (IS_BEYOND_STRAIN(material)) return LAW_RESPONSE(h, material);
#endif
  return strain_response(deformation_of(h, material), material);
}

#if DAMPING
#define MOST_VISCOUS_RATIO 0.46
float viscous_lambda(vec4 material) {
  if (material.y <= MOST_VISCOUS_RATIO) return lame_lambda(material);
  return 2.0 * MOST_VISCOUS_RATIO / (1.0 - 2.0 * MOST_VISCOUS_RATIO) * lame_mu(material);
}

float damping_over_h(Sym3 before, vec4 material) {
  float damping = damping_over_h(material);
  if (FADES_DAMPING(material)) damping /= max(1.0, 1.0 + 2.0 / 3.0 * (before.d.x + before.d.y + before.d.z));
  return damping;
}

Sym3 viscous_stress(uint t, Sym3 strain, vec4 material) {
  Sym3 before = previous_strain_of(t);
  float damping = damping_over_h(before, material);
  Sym3 rate = Sym3(damping * (strain.d - before.d), damping * (strain.s - before.s));
  return second_piola_stress(rate, viscous_lambda(material), lame_mu(material));
}
#endif

// Includes the damping over the substep.
Elastic response_of(uint t, mat3 h, vec4 material) {
  Elastic r = elastic_of(h, material);
#if DAMPING
  Sym3 e = green_strain(h), s = viscous_stress(t, e, material), before = previous_strain_of(t);
  mat3 p = times(mat3(1.0) + h, s);
  r.p += p;
  r.energy += 0.5 * contract(s, Sym3(e.d - before.d, e.s - before.s));
#endif
  return r;
}

// The strain-based part's second derivative of the energy: stiff dE : D : dE + dF S : dF with dE = sym(F^T dF). Where
// signed stretches guard a tet, it is that of St. Venant-Kirchhoff at the guarded F: the rotation of the principal
// directions is neglected.
struct Tangent {
  mat3 f;
  Sym3 s;
  float stiff;
  float lambda;  // of D [Pa]
};

Tangent elastic_tangent_of(mat3 h, vec4 material) {
#if BEYOND_STRAIN
  Tangent r = Tangent(mat3(1.0) + h, Sym3(vec3(0.0), vec3(0.0)), 0.0, lame_lambda(material));
  if (!IS_BEYOND_STRAIN(material)) {
    Deformation d = deformation_of(h, material);
    r = Tangent(d.f, second_piola_stress(d.e, material), 1.0, lame_lambda(material));
  }
#else
  Deformation d = deformation_of(h, material);
  Tangent r = Tangent(d.f, second_piola_stress(d.e, material), 1.0, lame_lambda(material));
#endif
  return r;
}

// Includes the damping over the substep.
Tangent tangent_of(uint t, mat3 h, vec4 material) {
  Tangent r = elastic_tangent_of(h, material);
#if DAMPING
  Sym3 viscous = viscous_stress(t, green_strain(h), material);
  r.s = Sym3(r.s.d + viscous.d, r.s.s + viscous.s);
  float damping = damping_over_h(previous_strain_of(t), material);
  r.stiff += damping;
  if (damping > 0.0) r.lambda += damping / r.stiff * (viscous_lambda(material) - r.lambda);
#endif
  return r;
}

// tr(a S b^T).
float geometric(mat3 a, Sym3 s, mat3 b) {
  return s.d.x * dot(a[0], b[0]) + s.d.y * dot(a[1], b[1]) + s.d.z * dot(a[2], b[2]) +
         s.s.x * (dot(a[1], b[2]) + dot(a[2], b[1])) + s.s.y * (dot(a[0], b[2]) + dot(a[2], b[0])) +
         s.s.z * (dot(a[0], b[1]) + dot(a[1], b[0]));
}

// Second derivative of the energy density along a and b, changes of F.
float curvature(Tangent tangent, mat3 h, vec4 material, mat3 a, mat3 b) {
  Sym3 s = second_piola_stress(strain_change(tangent.f, a), tangent.lambda, lame_mu(material));
  float sum = tangent.stiff * contract(s, strain_change(tangent.f, b)) + geometric(a, tangent.s, b);
#if BEYOND_STRAIN
  if (IS_BEYOND_STRAIN(material)) sum += LAW_CURVATURE(h, material, a, b);
#endif
  return sum;
}

// Second derivative by the position of one corner, whose shape function has the gradient b, without its negative part,
// which can only come from b.Sb:
//   max(0, b.Sb) I + stiff ((lambda + mu) (F b)(F b)^T + mu |b|^2 F F^T).
Sym3 strain_block(Tangent tangent, vec4 material, vec3 b) {
  mat3 f = tangent.f;
  vec3 fb = f * b;
  vec3 r0 = vec3(f[0].x, f[1].x, f[2].x), r1 = vec3(f[0].y, f[1].y, f[2].y), r2 = vec3(f[0].z, f[1].z, f[2].z);
  float mu = lame_mu(material), outer = tangent.stiff * (tangent.lambda + mu), inner = tangent.stiff * mu * dot(b, b);
  return Sym3(outer * fb * fb + inner * vec3(dot(r0, r0), dot(r1, r1), dot(r2, r2)) + max(0.0, dot(b, times(tangent.s, b))),
              outer * fb.yxx * fb.zzy + inner * vec3(dot(r1, r2), dot(r0, r2), dot(r0, r1)));
}

Sym3 corner_block(Tangent tangent, mat3 h, vec4 material, vec3 b) {
  Sym3 block = strain_block(tangent, material, b);
#if BEYOND_STRAIN
  if (IS_BEYOND_STRAIN(material)) {
    Sym3 more = LAW_BLOCK(h, material, b);
    block = Sym3(block.d + more.d, block.s + more.s);
  }
#endif
  return block;
}
