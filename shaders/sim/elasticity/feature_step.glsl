// The displacements at which kernels of tets compute forces. With MOVES these are the ones after the step of
// sim/two_level/subspace_step.glsl, which gradient stores later: no dispatch in between has to apply it.
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u, before the step [m]
#if MOVES
#include "sim/two_level/subspace_move.glsl"
INPUT_VEC4(LastStep, last_step)  // [vertex_count] p [m]

vec3 displacement_of(uint v) { return moved(FETCH(displacement, v).xyz, v, FETCH(last_step, v).xyz); }
#else
vec3 displacement_of(uint v) { return FETCH(displacement, v).xyz; }
#endif
