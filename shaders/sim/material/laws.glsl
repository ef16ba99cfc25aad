// The laws that are not functions of the Green strain, one file each: NAME_response(h, material), NAME_curvature(h,
// material, a, b) and NAME_block(h, material, b). LAW_RESPONSE and the like, which call the functions of a tet's
// material, are generated from the table of laws (sim/gpu/passes/features.cpp).
#include "sim/material/invariants.glsl"
#if STABLE_NEO_HOOKEAN
#include "sim/material/stable_neo_hookean.glsl"
#endif
#if NEO_HOOKEAN
#include "sim/material/neo_hookean.glsl"
#endif
#if SQUARED
#include "sim/material/squared.glsl"
#endif
#if MOONEY_RIVLIN
#include "sim/material/mooney_rivlin.glsl"
#endif
