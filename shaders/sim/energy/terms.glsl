// The sum of the external energies of the step's objective at a vertex. Each term is one file with two functions, for
// methods that descend the objective: NAME_gradient(v, u, scale), and NAME_stiffness(v, scale) where its stiffness is
// the same in every direction, else NAME_block_of(v, scale). EXTERNAL_GRADIENT, EXTERNAL_STIFFNESS and EXTERNAL_BLOCK,
// the sums over the terms that act, are generated from the solver's list (sim/gpu/passes/energy_term.cpp).
#if GRAB
#include "sim/energy/grab.glsl"
#endif
#if CONTACT
#include "sim/energy/contact.glsl"
#endif

// xyz dE/du [N], w 2 E [J], both times `scale`.
vec4 external_gradient(uint v, vec3 u, float scale) {
#ifdef EXTERNAL_GRADIENT
  return EXTERNAL_GRADIENT(v, u, scale);
#else
  return vec4(0.0);
#endif
}

// The factor of the identity in the vertex's block of the Hessian [N/m], times `scale`.
float external_stiffness(uint v, float scale) {
#ifdef EXTERNAL_STIFFNESS
  return EXTERNAL_STIFFNESS(v, scale);
#else
  return 0.0;
#endif
}

// The rest of that block.
#ifdef EXTERNAL_BLOCK
#define ADD_EXTERNAL_BLOCK(sum, v, scale) \
  {                                       \
    Sym3 more = EXTERNAL_BLOCK(v, scale); \
    sum.d += more.d;                      \
    sum.s += more.s;                      \
  }
#else
#define ADD_EXTERNAL_BLOCK(sum, v, scale)
#endif
