// Elastic (and viscous) force of every pair of tets on its corners, and its energy: the terms of tets in the objective
// of an implicit Euler step, 1/2 (u - u~)^T M (u - u~) + h^2 sum V [Psi(eps) + damping/h Psi(eps - eps_n)].
// Reads displacement; writes the slots that gradient gathers: xyz h^2 V P b_a [kg m], w of the first corner: the energy
// [kg m^2]. With CLUSTERS a work group adds the forces of its pairs before it stores them.
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/tet_pair.glsl"
#if CLUSTERS
#include "common/cluster.glsl"
#else
#include "common/pair_slots.glsl"
#endif
#include "sim/elasticity/elasticity.glsl"
COMPUTE_1D
#include "sim/elasticity/feature_step.glsl"
#if COMPENSATED
INPUT_VEC4(DisplacementLow, displacement_low)  // [vertex_count] the part of u that float32 cannot represent [m]
#endif

PairGradient gradients_of(TetPair pair) {
  PairGradient h = gradients(pair, displacement_of(pair.a.v.x), displacement_of(pair.a.v.y), displacement_of(pair.a.v.z),
                             displacement_of(pair.a.v.w), displacement_of(pair.b.v.w));
#if COMPENSATED
  PairGradient low = GRADIENTS(pair, displacement_low);
  h = PairGradient(h.a + low.a, h.b + low.b);
#endif
  return h;
}

struct PairForces {
  vec3 s0, s1, s2, x, y;
  float energy;
};

PairForces forces_of(TetPair pair, PairGradient h) {
  float scale_a = SUBSTEP * SUBSTEP * pair.a.volume, scale_b = SUBSTEP * SUBSTEP * pair.b.volume;
  Elastic a = response_of(pair.ta, h.a, material_of(pair.ta)), b = response_of(pair.tb, h.b, material_of(pair.tb));
  a.p *= scale_a;
  b.p *= scale_b;
  vec3 s1 = a.p * pair.a.b1 + b.p * pair.b.b2, s2 = a.p * pair.a.b2 + b.p * pair.b.b1, x = a.p * pair.a.b3, y = b.p * pair.b.b3;
  return PairForces(-(s1 + s2 + x + y), s1, s2, x, y, scale_a * a.energy + (pair.two ? scale_b * b.energy : 0.0));
}

#if CLUSTERS
void main() {
  uint cluster = cluster_of_group(), lane = gl_LocalInvocationID.x, i = uint(GROUP_SIZE) * cluster + lane;
  PairForces f = PairForces(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
  if (pair_counts(i, lane)) {
    TetPair pair = load_pair(i);
    f = forces_of(pair, gradients_of(pair));
  }
  keep_corner(0u, lane, f.s0);
  keep_corner(1u, lane, f.s1);
  keep_corner(2u, lane, f.s2);
  keep_corner(3u, lane, f.x);
  keep_corner(4u, lane, f.y);
  pair_energy[lane] = f.energy;
  store_cluster(cluster, lane);
}
#else
void main() {
  ITEM_OR_RETURN(i)
  TetPair pair = load_pair(i);
  PairGradient h = gradients_of(pair);
  DEFER_GUARDED(i, pair, h)
  PairForces f = forces_of(pair, h);
  uvec4 slot = FETCH(pair_slots, i);
  correction[slot.x] = vec4(f.s0, f.energy);
  STORE3(correction[slot.y], f.s1)
  STORE3(correction[slot.z], f.s2)
  STORE3(correction[slot.w], f.x)
  if (pair.two) STORE3(correction[pair.fifth_slot], f.y)
}
#endif
