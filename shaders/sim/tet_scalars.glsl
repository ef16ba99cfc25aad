// Numbers that the heat map shows.
float strain_norm(Sym3 e) { return sqrt(contract(e, e)); }

// Von Mises stress of the Cauchy stress F S F^T / J [Pa].
float von_mises_stress(mat3 f, float j, Sym3 s) {
  vec3 p0 = times(s, vec3(f[0].x, f[1].x, f[2].x));  // S f_r for the rows f_r of F
  vec3 p1 = times(s, vec3(f[0].y, f[1].y, f[2].y));
  vec3 p2 = times(s, vec3(f[0].z, f[1].z, f[2].z));
  vec3 r0 = vec3(f[0].x, f[1].x, f[2].x), r1 = vec3(f[0].y, f[1].y, f[2].y), r2 = vec3(f[0].z, f[1].z, f[2].z);
  vec3 d = vec3(dot(r0, p0), dot(r1, p1), dot(r2, p2));
  vec3 o = vec3(dot(r1, p2), dot(r0, p2), dot(r0, p1));
  vec3 g = d - d.yzx;
  return sqrt(0.5 * dot(g, g) + 3.0 * dot(o, o)) / max(abs(j), 1e-6);
}
