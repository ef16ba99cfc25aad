// Compressible neo-Hookean material (sim/material/neo_hookean.cpp), written in H = F - I and C1 = cof F - I:
//   P = mu (H - C1) + (mu (1 - l'(J)) + lambda v'(J)) C
Elastic neo_hookean_response(mat3 h, vec4 material) {
  Growth growth = growth_of(h, green_strain(h));
  float mu = lame_mu(material);
  OfVolume above = above_extended_log(growth.j1, LEAST_VOLUME_RATIO), volume = volume_term(growth.j1, lame_lambda(material));
  mat3 cofactor1 = cofactor_minus_one(h);
  return Elastic(mu * (h - cofactor1) + (mu * above.first + volume.first) * (mat3(1.0) + cofactor1),
                 mu * (growth.excess + above.value) + volume.value);
}

// Second derivative of the energy density along a and b, changes of F.
float neo_hookean_curvature(mat3 h, vec4 material, mat3 a, mat3 b) {
  float mu = lame_mu(material), j1 = det_f_minus_one(h);
  OfVolume above = above_extended_log(j1, LEAST_VOLUME_RATIO), volume = volume_term(j1, lame_lambda(material));
  mat3 f = mat3(1.0) + h, cofactor = mat3(1.0) + cofactor_minus_one(h);
  return mu * inner(a, b) + (mu * above.second + volume.second) * inner(cofactor, a) * inner(cofactor, b) +
         (mu * (above.first - 1.0) + volume.first) * inner(f, tensor_cross(a, b));
}

// Second derivative by the position of one corner, whose shape function has the gradient b. J is linear in the
// position, so the block is positive semidefinite except for a negative second derivative by J, which is neglected.
Sym3 neo_hookean_block(mat3 h, vec4 material, vec3 b) {
  float mu = lame_mu(material), j1 = det_f_minus_one(h);
  float outer = max(0.0, mu * above_extended_log(j1, LEAST_VOLUME_RATIO).second + volume_term(j1, lame_lambda(material)).second);
  vec3 cb = b + cofactor_minus_one(h) * b;
  return Sym3(mu * dot(b, b) + outer * cb * cb, outer * cb.yxx * cb.zzy);
}

// lambda - K of volume_split() (sim/material/law.h).
float neo_hookean_pointwise_lambda(vec4 material) { return 0.0; }
