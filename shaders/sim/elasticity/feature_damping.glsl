// Kelvin-Voigt damping: the strain at the start of the substep, from which the strain rate follows. Neutral value:
// gamma = 0.
#include "common/step.glsl"
#include "common/symmetric.glsl"
#if DAMPING
INPUT_VEC4(PreviousStrain, previous_strain)  // [2 * tet_count] xyz of xx, yy, zz then of yz, xz, xy
float damping_over_h(vec4 material) { return material.z / SUBSTEP; }
Sym3 previous_strain_of(uint t) {
  return Sym3(FETCH(previous_strain, 2u * t).xyz, FETCH(previous_strain, 2u * t + 1u).xyz);
}
#else
float damping_over_h(vec4 material) { return 0.0; }
Sym3 previous_strain_of(uint t) { return Sym3(vec3(0.0), vec3(0.0)); }
#endif
