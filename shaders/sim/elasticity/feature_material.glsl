// The material of a tet: one for the whole scene (a uniform), or one per region looked up by tet.
// vec4: x E [Pa], y nu [-], z damping [s], w model (MaterialModel). Which models the scene has is known when a kernel is compiled:
// the material is asked for its own only where there are several.
#include "common/step.glsl"
#if MATERIAL_PER_TET
INPUT_UINT(TetMaterial, tet_material)  // [tet_count]
INPUT_VEC4(Materials, materials)       // [material_count]
vec4 material_of(uint t) { return FETCH(materials, FETCH1(tet_material, t)); }
#else
vec4 material_of(uint t) { return step_values.material; }
#endif

#if SIGNED_ST_VENANT_KIRCHHOFF + ST_VENANT_KIRCHHOFF + STABLE_NEO_HOOKEAN == 1
#define HAS_MODEL(material, number) true
#else
#define HAS_MODEL(material, number) (material.w == number)
#endif
#define IS_SIGNED_ST_VENANT_KIRCHHOFF(material) HAS_MODEL(material, 0.0)
#define IS_STABLE_NEO_HOOKEAN(material) HAS_MODEL(material, 2.0)
