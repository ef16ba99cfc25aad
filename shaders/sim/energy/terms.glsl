// The sum of the external energies of the step's objective at a vertex. Each term is one file with two functions, for
// methods that descend the objective: NAME_gradient(v, u, scale) and NAME_stiffness(v, scale). EXTERNAL_GRADIENT and
// EXTERNAL_STIFFNESS, the sums over the terms that act, are generated from the solver's list
// (sim/gpu/passes/energy_term.cpp).
#if GRAB
#include "sim/energy/grab.glsl"
#endif

// xyz dE/du [N], w 2 E [J], both times `scale`.
vec4 external_gradient(uint v, vec3 u, float scale) {
#if EXTERNAL
  return EXTERNAL_GRADIENT(v, u, scale);
#else
  return vec4(0.0);
#endif
}

// The factor of the identity in the vertex's block of the Hessian [N/m], times `scale`.
float external_stiffness(uint v, float scale) {
#if EXTERNAL
  return EXTERNAL_STIFFNESS(v, scale);
#else
  return 0.0;
#endif
}
