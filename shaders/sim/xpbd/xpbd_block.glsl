// XPBD's block constraint of one tet (Macklin, Mueller, Chentanez 2016, eq. 18, with the Green strain as a 6-vector as
// in Boukadida, Andrews, Paquette 2019):
//
//   [ (1 + g) G M^-1 G^T + alpha~ ] dlambda = -(C + g (C - C_n)) - alpha~ lambda,   dx_a = w_a G_a^T dlambda
//
// C: Green strain with tensor shears; alpha~ = (V D)^-1 / h^2, where D has 4 mu on the shear diagonal because C counts
// each shear once; g = damping / h. The Jacobian is never formed: with C^ = F^T F and W = sum_a w_a b_a b_a^T the
// matrix entries are (G M^-1 G^T)_kl = tr(E_k C^ E_l W), E_k the unit strains, and G_a^T dlambda = F mat(dlambda) b_a.
// With signed stretches C and F are the guarded ones; the viscous C - C_n uses the plain strain.
#include "common/step.glsl"
#include "common/tet.glsl"
#include "common/solve6.glsl"
#include "sim/elasticity/feature_damping.glsl"
#include "sim/material/deformation.glsl"

struct BlockStep {
  vec3 change_d, change_s;      // dlambda, xx, yy, zz and yz, xz, xy
  vec3 dx0, dx1, dx2, dx3;      // corrections of the corners [m]
};

// h: displacement gradient of tet t. inverse_mass [1/kg]: of its corners. `foreseen`: change of strain that the corners
// will undergo in any case.
BlockStep solve_block(uint t, Tet tet, mat3 h, Deformation deformation, vec4 inverse_mass, vec3 lambda_d, vec3 lambda_s, Sym3 foreseen) {
  vec4 material = material_of(t);
  mat3 f = deformation.f;
  Sym3 e = deformation.e;
  vec3 b0 = -(tet.b1 + tet.b2 + tet.b3);

  Sym3 c = Sym3(vec3(dot(f[0], f[0]), dot(f[1], f[1]), dot(f[2], f[2])), vec3(dot(f[1], f[2]), dot(f[0], f[2]), dot(f[0], f[1])));
  vec3 p0 = inverse_mass.x * b0, p1 = inverse_mass.y * tet.b1, p2 = inverse_mass.z * tet.b2, p3 = inverse_mass.w * tet.b3;
  Sym3 w = Sym3(p0 * b0 + p1 * tet.b1 + p2 * tet.b2 + p3 * tet.b3,
                p0.yxx * b0.zzy + p1.yxx * tet.b1.zzy + p2.yxx * tet.b2.zzy + p3.yxx * tet.b3.zzy);

  float damping = damping_over_h(material);
  float compliance = 1.0 / (tet.volume * SUBSTEP * SUBSTEP * material.x);  // of the xx entry
  float lateral = -material.y * compliance;
  float shear = 0.5 * (1.0 + material.y) * compliance;  // 1 / (4 mu)

  vec3 change_d = foreseen.d - e.d - (compliance - lateral) * lambda_d - lateral * (lambda_d.x + lambda_d.y + lambda_d.z);
  vec3 change_s = foreseen.s - e.s - shear * lambda_s;
#if DAMPING
  Sym3 plain = green_strain(h), before = previous_strain_of(t);
  change_d -= damping * (plain.d - foreseen.d - before.d);
  change_s -= damping * (plain.s - foreseen.s - before.s);
#endif

  float s = 1.0 + damping, q = 0.25 * s;
  Lower6 m;
  m.m00 = s * c.d.x * w.d.x + compliance;
  m.m10 = s * c.s.z * w.s.z + lateral;
  m.m11 = s * c.d.y * w.d.y + compliance;
  m.m20 = s * c.s.y * w.s.y + lateral;
  m.m21 = s * c.s.x * w.s.x + lateral;
  m.m22 = s * c.d.z * w.d.z + compliance;
  m.m30 = 2.0 * q * (c.s.z * w.s.y + c.s.y * w.s.z);
  m.m31 = 2.0 * q * (c.d.y * w.s.x + c.s.x * w.d.y);
  m.m32 = 2.0 * q * (c.s.x * w.d.z + c.d.z * w.s.x);
  m.m33 = q * (2.0 * c.s.x * w.s.x + c.d.y * w.d.z + c.d.z * w.d.y) + shear;
  m.m40 = 2.0 * q * (c.d.x * w.s.y + c.s.y * w.d.x);
  m.m41 = 2.0 * q * (c.s.z * w.s.x + c.s.x * w.s.z);
  m.m42 = 2.0 * q * (c.s.y * w.d.z + c.d.z * w.s.y);
  m.m43 = q * (c.s.z * w.d.z + c.s.x * w.s.y + c.s.y * w.s.x + c.d.z * w.s.z);
  m.m44 = q * (2.0 * c.s.y * w.s.y + c.d.x * w.d.z + c.d.z * w.d.x) + shear;
  m.m50 = 2.0 * q * (c.d.x * w.s.z + c.s.z * w.d.x);
  m.m51 = 2.0 * q * (c.s.z * w.d.y + c.d.y * w.s.z);
  m.m52 = 2.0 * q * (c.s.y * w.s.x + c.s.x * w.s.y);
  m.m53 = q * (c.s.z * w.s.x + c.d.y * w.s.y + c.s.y * w.d.y + c.s.x * w.s.z);
  m.m54 = q * (c.d.x * w.s.x + c.s.y * w.s.z + c.s.z * w.s.y + c.s.x * w.d.x);
  m.m55 = q * (2.0 * c.s.z * w.s.z + c.d.x * w.d.y + c.d.y * w.d.x) + shear;
  solve6(m, change_d, change_s);  // right-hand side in, solution out

  Sym3 change = with_halved_shears(change_d, change_s);
  return BlockStep(change_d, change_s, f * times(change, p0), f * times(change, p1), f * times(change, p2), f * times(change, p3));
}
