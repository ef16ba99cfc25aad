// Inertial prediction u~ = u* + l v* + l^2 g of every vertex; the iterations start there (sim/integrators/stage.h).
// Without EXTRAPOLATES, u* and v* are displacement and velocity. Reads velocity and the inverse masses; writes
// previous_displacement, predicted, displacement (w: inverse mass). First pass of a stage, but for the strains of
// damped materials where EXTRAPOLATES. Constrained vertices (inverse mass 0) are not moved; their u~ is without gravity.
// With START_WITHOUT_GRAVITY the iterations start where the velocity leads instead: a stiff supported body hardly
// follows gravity within a step. UNCONSTRAINED: except in unconstrained components, which fall as predicted.
// With MASS_SPLITTING the w of displacement is the inverse mass of each of a vertex's n copies: a share m / n of its
// mass (Tonge, Benevolenski, Voroshilov 2012). The mean of the n corrections then equals their sum at full mass:
// positions get the same step as the multipliers. Copies: one per tet around the vertex (Jacobi), or the vertex and its
// phantoms (colors).
#include "common/io.glsl"
#include "common/step.glsl"
COMPUTE_1D
INPUT_VEC4(RestPosition, rest_position)  // [vertex_count] xyz X [m], w inverse mass [1/kg]
INPUT_VEC4(Velocity, velocity)           // [vertex_count] [m/s]
INPUT_VEC4_IN_PLACE(Iterate, iterate)    // [vertex_count] u [m]
OUTPUT(vec4, Displacement, displacement)
#if MASS_SPLITTING
INPUT_UINT(CopyBegin, copy_begin)  // [vertex_count + 1] differences are the numbers of copies
float copies(uint i) { return float(FETCH1(copy_begin, i + 1u) - FETCH1(copy_begin, i)); }
#else
float copies(uint i) { return 1.0; }
#endif
#ifdef UNCONSTRAINED
INPUT_UINT(Unconstrained, unconstrained)  // [vertex_count] not 0: starts with gravity
#endif
#ifdef EXTRAPOLATES
// [vertex_count] u and v at the start of the stage or substep before; u becomes this stage's own at the end of this pass,
// v with the velocities
INOUT(vec4, EarlierDisplacement, earlier_displacement)
INPUT_VEC4(EarlierVelocity, earlier_velocity)
#endif
OUTPUT(vec4, PreviousDisplacement, previous_displacement)  // [vertex_count] u* [m]
OUTPUT(vec4, Predicted, predicted)

#ifdef LISTED
uniform uint moving_count;  // in the list: the others rest and are constrained where they are
#endif

void main() {
  ITEM_OR_RETURN(i)
  vec3 u = FETCH_IN_PLACE(iterate, i).xyz;
  float inv_mass = FETCH(rest_position, i).w;
#ifdef LISTED
  bool rests = INVOCATION >= moving_count;
  if (rests) inv_mass = 0.0;
#else
  const bool rests = false;
#endif
  vec3 fall = inv_mass > 0.0 ? SUBSTEP * SUBSTEP * GRAVITY : vec3(0.0);
#ifdef EXTRAPOLATES
  vec3 v = FETCH(velocity, i).xyz;
  vec3 from = u + EXTRAPOLATION * (u - earlier_displacement[i].xyz);
  vec3 drift = inv_mass > 0.0 ? STAGE_DURATION * v : vec3(0.0);
  vec3 inertial = rests ? vec3(0.0) : SUBSTEP * (v + EXTRAPOLATION * (v - FETCH(earlier_velocity, i).xyz));
  if (rests) from = u;
  earlier_displacement[i] = vec4(u, 0.0);
  vec3 all = from + (inertial + fall);
#else
  vec3 inertial = rests ? vec3(0.0) : SUBSTEP * FETCH(velocity, i).xyz;
  vec3 from = u, drift = inv_mass > 0.0 ? inertial : vec3(0.0);
  vec3 all = u + (inertial + fall);
#endif
  previous_displacement[i] = vec4(from, inv_mass);
  predicted[i] = vec4(all, inv_mass);
#if START_WITHOUT_GRAVITY
  vec3 start = u + drift;
#ifdef UNCONSTRAINED
  if (FETCH1(unconstrained, i) != 0u) start = all;
#endif
  displacement[i] = vec4(start, inv_mass);
#else
  displacement[i] = vec4(all, copies(i) * inv_mass);
#endif
}
