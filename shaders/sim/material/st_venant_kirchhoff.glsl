// St. Venant-Kirchhoff: S = lambda tr(eps) I + 2 mu eps, Psi = 1/2 S : eps.
float lame_lambda(vec4 material) {
  return material.x * material.y / ((1.0 + material.y) * (1.0 - 2.0 * material.y));
}
float lame_mu(vec4 material) { return material.x / (2.0 * (1.0 + material.y)); }

Sym3 second_piola_stress(Sym3 e, float lambda, float mu) {
  float mu2 = 2.0 * mu;
  return Sym3(mu2 * e.d + lambda * (e.d.x + e.d.y + e.d.z), mu2 * e.s);
}

Sym3 second_piola_stress(Sym3 e, vec4 material) {
  return second_piola_stress(e, lame_lambda(material), lame_mu(material));
}
