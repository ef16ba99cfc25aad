// The scalar of the heat map, weighted by volume, into the slots that publish averages: x volume * scalar, y volume.
// Runs only while the map is shown.
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/tet_pair.glsl"
#include "common/pair_slots.glsl"
#include "sim/elasticity/elasticity.glsl"
#include "sim/elasticity/tet_scalars.glsl"
#if HEAT_LARGEST_STRESS || HEAT_SMALLEST_STRESS
#include "sim/elasticity/principal_stress.glsl"
#endif
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]

vec4 weighted(uint t, float volume, mat3 h) {
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
  return vec4(volume * scalar, volume, 0.0, 0.0);
}

void main() {
  ITEM_OR_RETURN(i)
  TetPair pair = load_pair(i);
  PairGradient h = GRADIENTS(pair, displacement);
  vec4 a = weighted(pair.ta, pair.a.volume, h.a), b = pair.two ? weighted(pair.tb, pair.b.volume, h.b) : vec4(0.0);
  uvec4 slot = FETCH(pair_slots, i);
  correction[slot.x] = a + b;
  correction[slot.y] = a + b;
  correction[slot.z] = a + b;
  correction[slot.w] = a;
  if (pair.two) correction[pair.fifth_slot] = b;
}
