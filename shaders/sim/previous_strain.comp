// Green strain of every tet at the start of the substep, for the strain rate of damped materials. After predict.
#include "common/io.glsl"
#include "common/symmetric.glsl"
#include "common/tet.glsl"
COMPUTE_1D
INPUT_VEC4(PreviousDisplacement, previous_displacement)  // [vertex_count] u_n [m]
OUTPUT(vec4, PreviousStrain, previous_strain)            // [2 * tet_count]

void main() {
  ITEM_OR_RETURN(t)
  Tet tet = load_tet(t);
  Sym3 e = green_strain(displacement_gradient(
      tet, FETCH(previous_displacement, tet.v.x).xyz, FETCH(previous_displacement, tet.v.y).xyz,
      FETCH(previous_displacement, tet.v.z).xyz, FETCH(previous_displacement, tet.v.w).xyz));
  STORE3(previous_strain[2u * t], e.d)
  STORE3(previous_strain[2u * t + 1u], e.s)
}
