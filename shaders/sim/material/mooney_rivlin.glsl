// Compressible Mooney-Rivlin material (sim/material/mooney_rivlin.cpp), written in H = F - I and C1 = cof F - I:
//   P = 2 c1 (H - C1) + 2 c2 (F x C - 2 I - 2 C1) + (d (1 - l'(J)) + k v'(J)) C, d = 2 (c1 + 2 c2)
struct MooneyRivlin {
  float two_c1, two_c2, d, k;
};
MooneyRivlin mooney_rivlin_of(vec4 material) {
  float mu = lame_mu(material), ratio = mooney_ratio(material);
  return MooneyRivlin((1.0 - ratio) * mu, ratio * mu, (1.0 + ratio) * mu, lame_lambda(material) - 2.0 * ratio * mu);
}

Elastic mooney_rivlin_response(mat3 h, vec4 material) {
  MooneyRivlin m = mooney_rivlin_of(material);
  Sym3 e = green_strain(h);
  Growth growth = growth_of(h, e);
  float trace_h = h[0].x + h[1].y + h[2].z;
  OfVolume above = above_extended_log(growth.j1, LEAST_VOLUME_RATIO), volume = volume_term(growth.j1, m.k);
  mat3 c1 = cofactor_minus_one(h);
  float trace_c = c1[0].x + c1[1].y + c1[2].z;
  // F x C - 2 I - 2 C1, without the identities that cancel.
  mat3 second = mat3(trace_h + trace_c) - transpose(h) - transpose(c1) + tensor_cross(h, c1) - 2.0 * c1;
  return Elastic(m.two_c1 * (h - c1) + m.two_c2 * second + (m.d * above.first + volume.first) * (mat3(1.0) + c1),
                 m.two_c1 * growth.excess + 2.0 * m.two_c2 * (growth.excess + growth.minors) +
                     m.d * above.value + volume.value);
}

// Second derivative of the energy density along a and b, changes of F.
float mooney_rivlin_curvature(mat3 h, vec4 material, mat3 a, mat3 b) {
  MooneyRivlin m = mooney_rivlin_of(material);
  float j1 = det_f_minus_one(h);
  OfVolume above = above_extended_log(j1, LEAST_VOLUME_RATIO), volume = volume_term(j1, m.k);
  mat3 f = mat3(1.0) + h, cofactor = mat3(1.0) + cofactor_minus_one(h), ab = tensor_cross(a, b);
  return m.two_c1 * inner(a, b) + m.two_c2 * (inner(tensor_cross(f, a), tensor_cross(f, b)) + inner(cofactor, ab)) +
         (m.d * above.second + volume.second) * inner(cofactor, a) * inner(cofactor, b) +
         (m.d * (above.first - 1.0) + volume.first) * inner(f, ab);
}

// As neo_hookean_block. Along e b^T the columns of the cofactors change by e x w, w_k = b_i f_j - b_j f_i.
Sym3 mooney_rivlin_block(mat3 h, vec4 material, vec3 b) {
  MooneyRivlin m = mooney_rivlin_of(material);
  float j1 = det_f_minus_one(h);
  float outer = max(0.0, m.d * above_extended_log(j1, LEAST_VOLUME_RATIO).second + volume_term(j1, m.k).second);
  vec3 cb = b + cofactor_minus_one(h) * b;
  mat3 f = mat3(1.0) + h, w = mat3(b.y * f[2] - b.z * f[1], b.z * f[0] - b.x * f[2], b.x * f[1] - b.y * f[0]);
  vec3 squares = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
  vec3 mixed = w[0].yxx * w[0].zzy + w[1].yxx * w[1].zzy + w[2].yxx * w[2].zzy;
  return Sym3(m.two_c1 * dot(b, b) + m.two_c2 * (squares.x + squares.y + squares.z - squares) + outer * cb * cb,
              outer * cb.yxx * cb.zzy - m.two_c2 * mixed);
}

// lambda - K of volume_split() (sim/material/law.h).
float mooney_rivlin_pointwise_lambda(vec4 material) { return 2.0 * mooney_ratio(material) * lame_mu(material); }
