// The inverse of a symmetric 3x3 matrix.
#include "common/symmetric.glsl"
Sym3 inverse_of(Sym3 a) {
  Sym3 c = Sym3(vec3(a.d.y * a.d.z - a.s.x * a.s.x, a.d.x * a.d.z - a.s.y * a.s.y, a.d.x * a.d.y - a.s.z * a.s.z),
                vec3(a.s.y * a.s.z - a.d.x * a.s.x, a.s.x * a.s.z - a.d.y * a.s.y, a.s.x * a.s.y - a.d.z * a.s.z));
  float i = 1.0 / (a.d.x * c.d.x + a.s.z * c.s.z + a.s.y * c.s.y);
  return Sym3(i * c.d, i * c.s);
}
