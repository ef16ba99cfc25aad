// Quantities of the heat map.
float strain_norm(Sym3 e) { return sqrt(contract(e, e)); }

// Von Mises stress of the Cauchy stress P F^T / J [Pa].
float von_mises_stress(mat3 f, float j, mat3 p) {
  mat3 c = p * transpose(f);
  vec3 d = vec3(c[0].x, c[1].y, c[2].z), o = vec3(c[1].z, c[0].z, c[0].y);
  vec3 g = d - d.yzx;
  return sqrt(0.5 * dot(g, g) + 3.0 * dot(o, o)) / max(abs(j), 1e-6);
}
