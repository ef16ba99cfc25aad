// Green strain of every tet at the start of the substep, for the strain rate of damped materials. After predict.
#include "common/io.glsl"
#include "common/symmetric.glsl"
#include "common/tet_pair.glsl"
COMPUTE_1D
INPUT_VEC4(PreviousDisplacement, previous_displacement)  // [vertex_count] u_n [m]
OUTPUT(vec4, PreviousStrain, previous_strain)            // [2 * tet_count]

void store(uint t, Sym3 e) {
  STORE3(previous_strain[2u * t], e.d)
  STORE3(previous_strain[2u * t + 1u], e.s)
}

void main() {
  ITEM_OR_RETURN(i)
  TetPair pair = load_pair(i);
  PairGradient h = GRADIENTS(pair, previous_displacement);
  store(pair.ta, green_strain(h.a));
  if (pair.two) store(pair.tb, green_strain(h.b));
}
