// Exact XPBD, second pass: the residual of the positions, g = M (u - u~) - sum G^T lambda, that XPBD assumes to be
// zero, and the raised mass m^ of every vertex. The tets then use n / m^ for a vertex with n tets, as with split
// masses. After exact_tet.
#include "common/io.glsl"
#include "common/step.glsl"
COMPUTE_1D
INPUT_VEC4(Predicted, predicted)    // [vertex_count] xyz u~ [m], w inverse mass, 0 where constrained
INPUT_FLOAT(Mass, mass)             // [vertex_count] [kg]
INPUT_UINT(SlotBegin, slot_begin)   // [vertex_count + 1]
INPUT_VEC4(Correction, correction)  // [slots] from exact_tet
INPUT_UINT(CopyBegin, copy_begin)   // [vertex_count + 1] differences are the numbers of tets
#include "sim/energy/terms.glsl"
INPUT_VEC4_IN_PLACE(Iterate, iterate)     // [vertex_count] u [m]
OUTPUT(vec4, Displacement, displacement)  // [vertex_count] w becomes n / m^ [1/kg]
OUTPUT(vec4, PrimalStep, primal_step)     // [vertex_count] xyz g / m^ [m]
OUTPUT(float, RaisedMass, raised_mass)    // [vertex_count] m^ [kg]

void main() {
  ITEM_OR_RETURN(i)
  uint begin = FETCH1(slot_begin, i), end = FETCH1(slot_begin, i + 1u);
  vec4 sum = vec4(0.0);
  for (uint k = begin; k < end; ++k) sum += FETCH(correction, k);
  vec4 predicted_i = FETCH(predicted, i);
  vec3 u = FETCH_IN_PLACE(iterate, i).xyz;
  float m = FETCH1(mass, i), k = external_stiffness(i, SUBSTEP * SUBSTEP);
  float raised = m + sum.w + k;
  float inverse = predicted_i.w > 0.0 ? 1.0 / raised : 0.0;
  displacement[i].w = float(FETCH1(copy_begin, i + 1u) - FETCH1(copy_begin, i)) * inverse;
  STORE3(primal_step[i], inverse * (m * (u - predicted_i.xyz) - sum.xyz + external_gradient(i, u, SUBSTEP * SUBSTEP).xyz))
  raised_mass[i] = raised;
}
