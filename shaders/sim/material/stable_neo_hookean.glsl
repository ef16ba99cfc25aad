// Stable neo-Hookean material (Smith, de Goes, Kim 2018, eq. 14, with their Lame parameters):
//   Psi = mu/2 (I - 3) + lambda/2 (J - alpha)^2 - mu/2 log(I + 1), I = |F|^2, alpha = 1 + 3 mu / (4 lambda), minus its
//   value at rest. Written in H = F - I, so that small strains lose no accuracy to stresses that cancel at rest.
float stable_neo_hookean_mu(vec4 material) { return 4.0 / 3.0 * lame_mu(material); }
float stable_neo_hookean_lambda(vec4 material) { return lame_lambda(material) + 5.0 / 6.0 * lame_mu(material); }

Elastic stable_neo_hookean_response(mat3 h, vec4 material) {
  float mu = stable_neo_hookean_mu(material), lambda = stable_neo_hookean_lambda(material);
  Sym3 e = green_strain(h);
  Growth growth = growth_of(h, e);
  float j1 = growth.j1, i3 = 2.0 * trace(e);
  mat3 cofactor1 = cofactor_minus_one(h), f = mat3(1.0) + h;
  return Elastic(lambda * j1 * (mat3(1.0) + cofactor1) + 0.75 * mu * (h - cofactor1) + 0.25 * mu * i3 / (i3 + 4.0) * f,
                 mu * (0.75 * growth.excess + 0.5 * above_logarithm(0.25 * i3)) + 0.5 * lambda * j1 * j1);
}

// Second derivative of the energy density along a and b, changes of F.
float stable_neo_hookean_curvature(mat3 h, vec4 material, mat3 a, mat3 b) {
  float mu = stable_neo_hookean_mu(material), lambda = stable_neo_hookean_lambda(material), i1 = stretch_invariant(h) + 4.0;
  mat3 f = mat3(1.0) + h, cofactor = mat3(1.0) + cofactor_minus_one(h);
  float ab = dot(a[0], b[0]) + dot(a[1], b[1]) + dot(a[2], b[2]);
  float fa = dot(f[0], a[0]) + dot(f[1], a[1]) + dot(f[2], a[2]), fb = dot(f[0], b[0]) + dot(f[1], b[1]) + dot(f[2], b[2]);
  float ca = dot(cofactor[0], a[0]) + dot(cofactor[1], a[1]) + dot(cofactor[2], a[2]),
        cb = dot(cofactor[0], b[0]) + dot(cofactor[1], b[1]) + dot(cofactor[2], b[2]);
  float second_j = dot(f[0], cross(a[1], b[2]) + cross(b[1], a[2])) + dot(f[1], cross(a[2], b[0]) + cross(b[2], a[0])) +
                   dot(f[2], cross(a[0], b[1]) + cross(b[0], a[1]));
  return mu * (1.0 - 1.0 / i1) * ab + 2.0 * mu / (i1 * i1) * fa * fb + lambda * ca * cb +
         (lambda * det_f_minus_one(h) - 0.75 * mu) * second_j;
}

// Second derivative by the position of one corner, whose shape function has the gradient b: positive semidefinite,
// since J is linear in the position.
Sym3 stable_neo_hookean_block(mat3 h, vec4 material, vec3 b) {
  float mu = stable_neo_hookean_mu(material), lambda = stable_neo_hookean_lambda(material), i1 = stretch_invariant(h) + 4.0;
  vec3 fb = b + h * b, cb = b + cofactor_minus_one(h) * b;
  float outer = 2.0 * mu / (i1 * i1);
  return Sym3(mu * (1.0 - 1.0 / i1) * dot(b, b) + outer * fb * fb + lambda * cb * cb,
              outer * fb.yxx * fb.zzy + lambda * cb.yxx * cb.zzy);
}

// lambda - K of volume_split() (sim/material/law.h).
float stable_neo_hookean_pointwise_lambda(vec4 material) { return 0.0; }
