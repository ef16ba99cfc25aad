// Kelvin-Voigt damping: the strain at the start of the substep, from which the strain rate follows. Neutral value:
// gamma = 0.
#include "common/step.glsl"
#include "common/symmetric.glsl"
#if DAMPING
// xx, yy, zz, yz, xz, xy of each linear tet, packed: two tets in three; on software renderers, where that would cost
// more than it saves, one in two. Then two for each point of a quadratic tet.
INPUT_VEC4(PreviousStrain, previous_strain)
float damping_over_h(vec4 material) { return material.z / SUBSTEP; }
Sym3 previous_strain_at(uint at) { return Sym3(FETCH(previous_strain, at).xyz, FETCH(previous_strain, at + 1u).xyz); }
Sym3 previous_strain_of(uint t) {
#if READ_TEXELS
  return previous_strain_at(2u * t);
#else
  uint at = 3u * (t / 2u) + t % 2u;
  vec4 first = FETCH(previous_strain, at), second = FETCH(previous_strain, at + 1u);
  return t % 2u == 0u ? Sym3(first.xyz, vec3(first.w, second.xy)) : Sym3(vec3(first.zw, second.x), second.yzw);
#endif
}
#else
float damping_over_h(vec4 material) { return 0.0; }
Sym3 previous_strain_of(uint t) { return Sym3(vec3(0.0), vec3(0.0)); }
#endif
