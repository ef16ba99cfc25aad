// Squared neo-Hookean material (sim/material/squared.cpp), written in H = F - I and C1 = cof F - I, i3 = |F|^2 - 3:
//   P = mu (H - C1) + mu i3/3 F + (mu (1 - l'(J)) + k v'(J)) C
// Eased or firm (sim/gpu/readback/tangle_watch.h), the material has a fraction beside the number of its model.
float squared_least_ratio(vec4 material) {
  float fraction = fract(material.w);
  return fraction == 0.0 ? 0.05 : fraction == 0.5 ? LEAST_VOLUME_RATIO : 0.003;
}

Elastic squared_response(mat3 h, vec4 material) {
  Sym3 e = green_strain(h);
  Growth growth = growth_of(h, e);
  float mu = lame_mu(material), i3 = 2.0 * trace(e);
  OfVolume above = above_extended_log(growth.j1, squared_least_ratio(material)), volume = volume_term(growth.j1, lame_lambda(material) - 2.0 / 3.0 * mu);
  mat3 cofactor1 = cofactor_minus_one(h);
  return Elastic(mu * (h - cofactor1) + mu / 3.0 * i3 * (mat3(1.0) + h) + (mu * above.first + volume.first) * (mat3(1.0) + cofactor1),
                 mu * (growth.excess + above.value + i3 * i3 / 12.0) + volume.value);
}

// Second derivative of the energy density along a and b, changes of F.
float squared_curvature(mat3 h, vec4 material, mat3 a, mat3 b) {
  float mu = lame_mu(material), j1 = det_f_minus_one(h);
  OfVolume above = above_extended_log(j1, squared_least_ratio(material)), volume = volume_term(j1, lame_lambda(material) - 2.0 / 3.0 * mu);
  mat3 f = mat3(1.0) + h, cofactor = mat3(1.0) + cofactor_minus_one(h);
  return mu * (1.0 + stretch_invariant(h) / 3.0) * inner(a, b) + 2.0 / 3.0 * mu * inner(f, a) * inner(f, b) +
         (mu * above.second + volume.second) * inner(cofactor, a) * inner(cofactor, b) +
         (mu * (above.first - 1.0) + volume.first) * inner(f, tensor_cross(a, b));
}

// As neo_hookean_block; the floor gives steps a length near F = 0, where every derivative vanishes.
Sym3 squared_block(mat3 h, vec4 material, vec3 b) {
  float mu = lame_mu(material), j1 = det_f_minus_one(h);
  float by_volume = max(0.0, mu * above_extended_log(j1, squared_least_ratio(material)).second + volume_term(j1, lame_lambda(material) - 2.0 / 3.0 * mu).second);
  float by_stretch = 2.0 / 3.0 * mu;
  vec3 fb = b + h * b, cb = b + cofactor_minus_one(h) * b;
  return Sym3(mu * max(0.25, 1.0 + stretch_invariant(h) / 3.0) * dot(b, b) + by_stretch * fb * fb + by_volume * cb * cb,
              by_stretch * fb.yxx * fb.zzy + by_volume * cb.yxx * cb.zzy);
}

// lambda - K of volume_split() (sim/material/law.h).
float squared_pointwise_lambda(vec4 material) { return 2.0 / 3.0 * lame_mu(material); }
