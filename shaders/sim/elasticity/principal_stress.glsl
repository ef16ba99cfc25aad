// Eigenvalues of the Cauchy stress P F^T / |J| [Pa], largest first. Computed by Jacobi rotations over the pairs of axes
// in turn: unlike the closed form with a cosine they stay accurate where two values are equal, as in every stretched
// bar.
vec3 principal_stresses(mat3 f, float j, mat3 p) {
  mat3 c = p * transpose(f) * (1.0 / max(abs(j), 1e-6));
  vec3 d = vec3(c[0].x, c[1].y, c[2].z), o = vec3(c[1].z, c[0].z, c[0].y);  // o: yz, xz, xy
  for (int rotation = 0; rotation < 12; ++rotation) {  // four for every pair of axes
    float theta = 0.5 * (d.y - d.x) / o.z;
    float t = (theta >= 0.0 ? 1.0 : -1.0) / (abs(theta) + sqrt(1.0 + theta * theta));
    if (!(abs(o.z) > 1e-9 * (abs(d.x) + abs(d.y)))) t = 0.0;
    float cosine = inversesqrt(1.0 + t * t), sine = cosine * t;
    d += t * o.z * vec3(-1.0, 1.0, 0.0);
    o = vec3(sine * o.y + cosine * o.x, cosine * o.y - sine * o.x, t == 0.0 ? o.z : 0.0);
    d = d.yzx;  // the next pair
    o = o.yzx;
  }
  float most = max(d.x, max(d.y, d.z)), least = min(d.x, min(d.y, d.z));
  return vec3(most, d.x + d.y + d.z - most - least, least);
}
