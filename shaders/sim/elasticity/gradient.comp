// Gradient g = M (u - u~) + h^2 dU/du of the step's objective at every vertex, including external energies, 0 where
// constrained, with the vertex's share of the objective in w; FROM_START: less its kinetic part at the start of the stage,
// where bodies may rest in contact. After elastic_force. A gather in fixed order, so runs
// repeat bit for bit. With MOVES it applies the step that elastic_force has computed with (feature_step.glsl).
#include "common/io.glsl"
#include "common/step.glsl"
COMPUTE_1D
INPUT_VEC4(Predicted, predicted)        // [vertex_count] xyz u~ [m], w inverse mass, 0 where constrained
INPUT_FLOAT(Mass, mass)                 // [vertex_count] the vertices' own masses [kg]
INPUT_UINT(SlotBegin, slot_begin)       // [vertex_count + 1]
INPUT_VEC4(Correction, correction)      // [slots] from elastic_force
#include "sim/energy/terms.glsl"
#if FROM_START
INPUT_VEC4(StartDisplacement, start_displacement)  // [vertex_count] u at the start of the stage [m]
#endif
#if MOVES
#include "sim/two_level/subspace_move.glsl"
INOUT(vec4, Iterate, iterate)                      // [vertex_count] u [m]
INOUT(vec4, LastStep, last_step)                   // [vertex_count] p [m]
INOUT(vec4, Gradient, gradient)                    // [vertex_count] xyz g [kg m], w objective [kg m^2]
OUTPUT(vec4, PreviousGradient, previous_gradient)  // [vertex_count] g before the new p

vec3 move(uint i) {
  vec3 p = last_step[i].xyz, u = moved(iterate[i].xyz, i, p), last = along_span(SUBSPACE_LAST_STEP, i, p);
  iterate[i].xyz = u;
  STORE3(last_step[i], last)
  if (FETCH1(subspace_state, SUBSPACE_ACCEPTED) > 0.5) STORE3(previous_gradient[i], gradient[i].xyz)
  return u;
}
#else
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]
OUTPUT(vec4, Gradient, gradient)        // [vertex_count] xyz g [kg m], w objective [kg m^2]

vec3 move(uint i) { return FETCH(displacement, i).xyz; }
#endif

void main() {
  ITEM_OR_RETURN(i)
  uint end = FETCH1(slot_begin, i + 1u);
  vec4 sum = vec4(0.0);
  for (uint k = FETCH1(slot_begin, i); k < end; ++k) sum += FETCH(correction, k);
  vec4 predicted_i = FETCH(predicted, i);
  vec3 u = move(i), d = u - predicted_i.xyz;
  float m = FETCH1(mass, i);
  vec4 more = external_gradient(i, u, SUBSTEP * SUBSTEP);
  vec4 g = sum + vec4(m * d + more.xyz, 0.5 * (m * dot(d, d) + more.w));
#if FROM_START
  // At rest (u_n - u~)^T M (u_n - u~) is most of the objective, and its rounding more than what elastic energy changes by.
  vec3 way = u - FETCH(start_displacement, i).xyz;
  g.w = sum.w + 0.5 * (m * dot(way, 2.0 * d - way) + more.w);
#endif
  gradient[i] = predicted_i.w > 0.0 ? g : vec4(0.0, 0.0, 0.0, sum.w);
}
