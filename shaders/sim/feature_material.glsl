// The material of a tet: one for the whole scene (a uniform), or one per region looked up by tet.
// vec4: x E [Pa], y nu [-], z damping [s], w density [kg/m^3].
#if MATERIAL_PER_TET
INPUT_UINT(TetMaterial, tet_material)  // [tet_count]
INPUT_VEC4(Materials, materials)       // [material_count]
vec4 material_of(uint t) { return FETCH(materials, FETCH1(tet_material, t)); }
#else
vec4 material_of(uint t) { return step_values.material; }
#endif
