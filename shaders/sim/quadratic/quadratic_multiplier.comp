// Multipliers of quadratic tets whose K is above K' = RELAXED_BULK mu. Blocks and coarse space converge slowly with a large K;
// the iterations see K' instead, and a multiplier q per tet for the rest (augmented Lagrangian: Hestenes 1969, Powell 1969):
//   K/2 theta^2 = max over q of  K'/2 theta^2 + q theta - q^2 / (2 (K - K')),  q = (K - K') theta there
// with theta its mean over the tet. Here q goes up by the gradient of that, theta - q / (K - K'), times K' (K - K') / K, which
// is its inverse second derivative where mu is small beside K'. Between updates the objective is that of fixed q. The first
// one of a state takes q from theta.
// With RENEWS also forgets the objective, which was that of other q. At the start of a stage, of u_n, or after the last step
// was judged.
#include "common/io.glsl"
#include "common/step.glsl"
#include "sim/quadratic/law.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)               // [vertex_count] u [m]
INOUT(float, UpdatedMultiplier, updated_multiplier)  // [quadratic_count] q [Pa], or UNKNOWN_MULTIPLIER
#if RENEWS
#include "sim/two_level/subspace_state.glsl"
OUTPUT(float, SubspaceState, subspace_state)
#endif

void main() {
  ITEM_OR_RETURN(e)
#if RENEWS
  if (INVOCATION == 0u) subspace_state[SUBSPACE_OBJECTIVE] = uintBitsToFloat(0x7f800000u);
#endif
  uint t = FIRST_QUADRATIC + e;
  Tet tet = load_tet(t);
  vec4 material = material_of(t);
  VolumeSplit split = volume_split(material);
  float relaxed = RELAXED_BULK * lame_mu(material), rest = split.bulk - relaxed;
  if (rest <= 0.0) return;
  float theta = mean_dilatation(POINT_GRADIENTS(e, tet, displacement), material), q = updated_multiplier[e];
  updated_multiplier[e] = q < UNKNOWN_MULTIPLIER ? q + (theta - q / rest) * (relaxed * rest / split.bulk) : rest * theta;
}
