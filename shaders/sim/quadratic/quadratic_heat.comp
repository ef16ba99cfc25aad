// The scalar of the heat map in quadratic tets, as heat_tet computes it for linear ones: at a corner that of the nearest
// point, in the middle of an edge the mean of both ends. Stress has the averaged pressure.
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/quadratic_slots.glsl"
#include "sim/quadratic/law.glsl"
#include "sim/elasticity/tet_scalars.glsl"
#if HEAT_LARGEST_STRESS || HEAT_SMALLEST_STRESS
#include "sim/elasticity/principal_stress.glsl"
#endif
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]

float scalar_of(mat3 h, mat3 p) {
#if HEAT_STRAIN
  return strain_norm(green_strain(h));
#elif HEAT_VOLUME_RATIO
  return 1.0 + det_f_minus_one(h);
#else
  mat3 f = mat3(1.0) + h;
  float j = 1.0 + det_f_minus_one(h);
#if HEAT_VON_MISES
  return von_mises_stress(f, j, p);
#elif HEAT_LARGEST_STRESS
  return principal_stresses(f, j, p).x;
#else
  return principal_stresses(f, j, p).z;
#endif
#endif
}

void main() {
  ITEM_OR_RETURN(e)
  uint t = FIRST_QUADRATIC + e;
  Tet tet = load_tet(t);
  PointGradients h = POINT_GRADIENTS(e, tet, displacement);
  vec4 material = material_of(t);
  QuadraticLaw law = law_of(e, h, material);
  vec4 at;
  for (int q = 0; q < 4; ++q) {
    mat3 point = PICK(h, q);
    at[q] = tet.volume * scalar_of(point, elastic_at(law, point, material).p);
  }
  uvec4 slot = FETCH(quadratic_slots, 3u * e);
  correction[slot.x] = vec4(at.x, tet.volume, 0.0, 0.0);
  correction[slot.y] = vec4(at.y, tet.volume, 0.0, 0.0);
  correction[slot.z] = vec4(at.z, tet.volume, 0.0, 0.0);
  correction[slot.w] = vec4(at.w, tet.volume, 0.0, 0.0);
  slot = FETCH(quadratic_slots, 3u * e + 1u);
  correction[slot.x] = vec4(0.5 * (at.x + at.y), tet.volume, 0.0, 0.0);
  correction[slot.y] = vec4(0.5 * (at.y + at.z), tet.volume, 0.0, 0.0);
  correction[slot.z] = vec4(0.5 * (at.x + at.z), tet.volume, 0.0, 0.0);
  correction[slot.w] = vec4(0.5 * (at.x + at.w), tet.volume, 0.0, 0.0);
  slot = FETCH(quadratic_slots, 3u * e + 2u);
  correction[slot.x] = vec4(0.5 * (at.y + at.w), tet.volume, 0.0, 0.0);
  correction[slot.y] = vec4(0.5 * (at.z + at.w), tet.volume, 0.0, 0.0);
}
