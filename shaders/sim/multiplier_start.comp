// Multipliers in balance with the stress, lambda = -h^2 V D (C + damping/h (C - C_n)), at the displacements from which the iterations
// start. D counts each tensor shear twice. After predict and prescribe.
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/symmetric.glsl"
#include "common/tet.glsl"
#include "sim/feature_material.glsl"
#include "sim/feature_damping.glsl"
#include "sim/material/st_venant_kirchhoff.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]
OUTPUT(vec4, Multiplier, multiplier)    // [2 * tet_count] lambda, xyz of xx, yy, zz then of yz, xz, xy

void main() {
  ITEM_OR_RETURN(t)
  Tet tet = load_tet(t);
  mat3 h = displacement_gradient(tet, FETCH(displacement, tet.v.x).xyz, FETCH(displacement, tet.v.y).xyz,
                                 FETCH(displacement, tet.v.z).xyz, FETCH(displacement, tet.v.w).xyz);
  Sym3 e = green_strain(h);
  vec4 material = material_of(t);
  float damping = damping_over_h(material);
  Sym3 before = previous_strain_of(t);
  Sym3 s = second_piola_stress(Sym3(e.d + damping * (e.d - before.d), e.s + damping * (e.s - before.s)), material);
  float scale = -SUBSTEP * SUBSTEP * tet.volume;
  multiplier[2u * t] = vec4(scale * s.d, 0.0);
  multiplier[2u * t + 1u] = vec4(2.0 * scale * s.s, 0.0);
}
