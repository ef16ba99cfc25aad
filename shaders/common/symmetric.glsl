// Symmetric 3x3 matrices and the Green strain.
struct Sym3 {
  vec3 d;  // xx, yy, zz
  vec3 s;  // yz, xz, xy
};

vec3 times(Sym3 a, vec3 v) {
  return vec3(dot(vec3(a.d.x, a.s.z, a.s.y), v), dot(vec3(a.s.z, a.d.y, a.s.x), v), dot(vec3(a.s.y, a.s.x, a.d.z), v));
}

mat3 times(mat3 f, Sym3 s) {
  return mat3(f * vec3(s.d.x, s.s.z, s.s.y), f * vec3(s.s.z, s.d.y, s.s.x), f * vec3(s.s.y, s.s.x, s.d.z));
}

float contract(Sym3 a, Sym3 b) { return dot(a.d, b.d) + 2.0 * dot(a.s, b.s); }

float trace(Sym3 a) { return a.d.x + a.d.y + a.d.z; }

// eps = sym(H) + 1/2 H^T H with F = I + H: no difference of nearly equal numbers at small strain.
Sym3 green_strain(mat3 h) {
  return Sym3(vec3(h[0].x, h[1].y, h[2].z) + 0.5 * vec3(dot(h[0], h[0]), dot(h[1], h[1]), dot(h[2], h[2])),
              0.5 * vec3(h[2].y + h[1].z + dot(h[1], h[2]), h[2].x + h[0].z + dot(h[0], h[2]),
                         h[1].x + h[0].y + dot(h[0], h[1])));
}

// Change of the Green strain with a change d of F: sym(F^T d).
Sym3 strain_change(mat3 f, mat3 d) {
  return Sym3(vec3(dot(f[0], d[0]), dot(f[1], d[1]), dot(f[2], d[2])),
              0.5 * vec3(dot(f[1], d[2]) + dot(f[2], d[1]), dot(f[0], d[2]) + dot(f[2], d[0]), dot(f[0], d[1]) + dot(f[1], d[0])));
}

// Voigt components with tensor shears, in the order xx, yy, zz, yz, xz, xy.
Sym3 with_halved_shears(vec3 d, vec3 s) { return Sym3(d, 0.5 * s); }
