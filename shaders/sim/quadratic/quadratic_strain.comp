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
OUTPUT(vec4, PreviousStrain, previous_strain)  // [8 * tet_count]

void main() {
  ITEM_OR_RETURN(t)
  Tet tet = load_tet(t);
  PointGradients h = POINT_GRADIENTS(t, tet, previous_displacement);
#ifdef EXTRAPOLATES
  PointGradients before = POINT_GRADIENTS(t, tet, earlier_displacement);
#endif
  for (int q = 0; q < 4; ++q) {
    Sym3 e = green_strain(h.at[q]);
#ifdef EXTRAPOLATES
    Sym3 earlier = green_strain(before.at[q]);
    e = Sym3(e.d + EXTRAPOLATION * (e.d - earlier.d), e.s + EXTRAPOLATION * (e.s - earlier.s));
#endif
    STORE3(previous_strain[8u * t + 2u * uint(q)], e.d)
    STORE3(previous_strain[8u * t + 2u * uint(q) + 1u], e.s)
  }
}
