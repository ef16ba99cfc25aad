// The scalar that the heat map shows, weighted by volume, into the slots that publish averages. Runs only while shown.
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/tet.glsl"
#include "sim/elasticity.glsl"
#include "sim/tet_scalars.glsl"
#if HEAT_LARGEST_STRESS || HEAT_SMALLEST_STRESS
#include "sim/principal_stress.glsl"
#endif
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]
INPUT_UVEC4(TetSlots, tet_slots)        // [tet_count]
OUTPUT(vec4, Correction, correction)    // [4 * tet_count] x volume * scalar, y volume

void main() {
  ITEM_OR_RETURN(t)
  Tet tet = load_tet(t);
  mat3 h = displacement_gradient(tet, FETCH(displacement, tet.v.x).xyz, FETCH(displacement, tet.v.y).xyz,
                                 FETCH(displacement, tet.v.z).xyz, FETCH(displacement, tet.v.w).xyz);
#if HEAT_STRAIN
  float scalar = strain_norm(green_strain(h));
#elif HEAT_VOLUME_RATIO
  float scalar = 1.0 + det_f_minus_one(h);
#else
  mat3 f = mat3(1.0) + h, p = elastic_of(h, material_of(t)).p;
  float j = 1.0 + det_f_minus_one(h);
#if HEAT_VON_MISES
  float scalar = von_mises_stress(f, j, p);
#elif HEAT_LARGEST_STRESS
  float scalar = principal_stresses(f, j, p).x;
#else
  float scalar = principal_stresses(f, j, p).z;
#endif
#endif
  vec4 weighted = vec4(tet.volume * scalar, tet.volume, 0.0, 0.0);
  uvec4 slot = FETCH(tet_slots, t);
  correction[slot.x] = weighted;
  correction[slot.y] = weighted;
  correction[slot.z] = weighted;
  correction[slot.w] = weighted;
}
