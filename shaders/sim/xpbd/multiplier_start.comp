// Multipliers in equilibrium with the stress, lambda = -h^2 V D (C + damping/h (C - C_n)), at the displacements from
// which the iterations start. D counts each tensor shear twice. After predict and prescribe.
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/tet.glsl"
#include "sim/elasticity/elasticity.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]
OUTPUT(vec4, Multiplier, multiplier)    // [2 * tet_count] lambda, xyz of xx, yy, zz then of yz, xz, xy

void main() {
  ITEM_OR_RETURN(t)
  Tet tet = load_tet(t);
  mat3 h = displacement_gradient(tet, FETCH(displacement, tet.v.x).xyz, FETCH(displacement, tet.v.y).xyz,
                                 FETCH(displacement, tet.v.z).xyz, FETCH(displacement, tet.v.w).xyz);
  Sym3 s = tangent_of(t, h, material_of(t)).s;
  float scale = -SUBSTEP * SUBSTEP * tet.volume;
  STORE3(multiplier[2u * t], scale * s.d)
  STORE3(multiplier[2u * t + 1u], 2.0 * scale * s.s)
}
