// Green strain eps* of every tet for the strain rate of damped materials (sim/integrators/stage.h). After predict, which
// stores u* = u_n; where EXTRAPOLATES before it, since it then replaces the earlier displacements.
#include "common/io.glsl"
#include "common/symmetric.glsl"
#include "common/tet_pair.glsl"
COMPUTE_1D
INPUT_VEC4(PreviousDisplacement, previous_displacement)  // [vertex_count] u_n [m]
#ifdef EXTRAPOLATES
#include "common/step.glsl"
INPUT_VEC4(EarlierDisplacement, earlier_displacement)  // [vertex_count] [m]
#endif
// As sim/elasticity/feature_damping.glsl reads it.
#if READ_TEXELS
OUTPUT(vec4, PreviousStrain, previous_strain)

void store(uint t, Sym3 e) {
  STORE3(previous_strain[2u * t], e.d)
  STORE3(previous_strain[2u * t + 1u], e.s)
}
#else
OUTPUT(float, PreviousStrain, previous_strain)

void store(uint t, Sym3 e) {
  previous_strain[6u * t] = e.d.x;
  previous_strain[6u * t + 1u] = e.d.y;
  previous_strain[6u * t + 2u] = e.d.z;
  previous_strain[6u * t + 3u] = e.s.x;
  previous_strain[6u * t + 4u] = e.s.y;
  previous_strain[6u * t + 5u] = e.s.z;
}
#endif

#ifdef EXTRAPOLATES
Sym3 extrapolated(Sym3 now, Sym3 earlier) {
  return Sym3(now.d + EXTRAPOLATION * (now.d - earlier.d), now.s + EXTRAPOLATION * (now.s - earlier.s));
}
#endif

void main() {
  ITEM_OR_RETURN(i)
  TetPair pair = load_pair(i);
  PairGradient h = GRADIENTS(pair, previous_displacement);
#ifdef EXTRAPOLATES
  PairGradient before = GRADIENTS(pair, earlier_displacement);
  store(pair.ta, extrapolated(green_strain(h.a), green_strain(before.a)));
  if (pair.two) store(pair.tb, extrapolated(green_strain(h.b), green_strain(before.b)));
#else
  store(pair.ta, green_strain(h.a));
  if (pair.two) store(pair.tb, green_strain(h.b));
#endif
}
