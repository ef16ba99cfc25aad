// The material of a tet: one for the whole scene (a uniform), or one per region looked up by tet.
// vec4: x E [Pa], y nu [-], z damping [s], w model (MaterialModel) + mooney_ratio / 2 of mooney_rivlin, + 1/2 of
// squared while it is eased, + 1/4 while it is firm. The models of the scene are known when a kernel is compiled, so the material's own model is
// read only if there are several.
#include "common/step.glsl"
#if MATERIAL_PER_TET
INPUT_UINT(TetMaterial, tet_material)  // [tet_count]
INPUT_VEC4(Materials, materials)       // [material_count]
vec4 material_of(uint t) { return FETCH(materials, FETCH1(tet_material, t)); }
#else
vec4 material_of(uint t) { return step_values.material; }
#endif

#if MOONEY_RIVLIN
float mooney_ratio(vec4 material) { return 2.0 * fract(material.w); }
#endif

#if LAW_COUNT == 1
#define HAS_MODEL(material, number) true
#else
#define HAS_MODEL(material, number) (floor(material.w) == number)
#endif
#define IS_SIGNED_ST_VENANT_KIRCHHOFF(material) HAS_MODEL(material, 0.0)
