// Green strain eps* at the points of every quadratic tet, as previous_strain computes it for linear ones.
#include "common/io.glsl"
#include "common/symmetric.glsl"
#include "common/quadratic_tet.glsl"
COMPUTE_1D
INPUT_VEC4(PreviousDisplacement, previous_displacement)  // [vertex_count] u_n [m]
#ifdef EXTRAPOLATES
#include "common/step.glsl"
INPUT_VEC4(EarlierDisplacement, earlier_displacement)  // [vertex_count] [m]
#endif
OUTPUT(vec4, PreviousStrain, previous_strain)  // after those of linear tets: [8 * quadratic_count]

void main() {
  ITEM_OR_RETURN(e)
  Tet tet = load_tet(FIRST_QUADRATIC + e);
  PointGradients h = POINT_GRADIENTS(e, tet, previous_displacement);
#ifdef EXTRAPOLATES
  PointGradients before = POINT_GRADIENTS(e, tet, earlier_displacement);
#endif
  for (int q = 0; q < 4; ++q) {
    Sym3 strain = green_strain(h.at[q]);
#ifdef EXTRAPOLATES
    Sym3 earlier = green_strain(before.at[q]);
    strain = Sym3(strain.d + EXTRAPOLATION * (strain.d - earlier.d), strain.s + EXTRAPOLATION * (strain.s - earlier.s));
#endif
    uint at = strain_of_point(e, q);
    STORE3(previous_strain[at], strain.d)
    STORE3(previous_strain[at + 1u], strain.s)
  }
}
