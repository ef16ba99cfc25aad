// Elastic (and viscous) force, energy, J, volume, strain and stress of every tet after a step. Each invocation
// processes its share of the pairs of tets and keeps its own sums, so the result is deterministic on every device.
// Writes h^2 times the force on each corner, -h^2 V P b_a [kg m], into the slots for diagnose_vertex, and one
// TetPartial per invocation.
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/tet_pair.glsl"
#include "common/pair_slots.glsl"
#include "sim/elasticity/elasticity.glsl"
#include "sim/elasticity/tet_scalars.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]
OUTPUT(TetPartial, TetPartials, tet_partials)  // [invocations]
uniform uint pair_and_single_count;

// Adds a tet to the sums. Returns -h^2 V P.
mat3 add_tet(inout TetPartial partial, uint t, float volume, mat3 h) {
  vec4 material = material_of(t);
  Elastic elastic = elastic_of(h, material);
  float growth = det_f_minus_one(h), j = 1.0 + growth;
  float strain = strain_norm(green_strain(h));
  partial.range = vec4(min(partial.range.x, j), max(partial.range.y, j), max(partial.range.z, strain),
                       max(partial.range.w, von_mises_stress(mat3(1.0) + h, j, elastic.p)));
  partial.sums += volume * vec4(elastic.energy, 0.0, growth, strain * strain);
  partial.sums.y += j <= 0.0 ? 1.0 : 0.0;
  return -SUBSTEP * SUBSTEP * volume * response_of(t, h, material).p;
}

void main() {
  ITEM_OR_RETURN(lane)
  TetPartial partial = TetPartial(vec4(3.4e38, -3.4e38, 0.0, 0.0), vec4(0.0));
  FOR_ITEMS_OF_LANE(i, lane, invocations, pair_and_single_count) {
    TetPair pair = load_pair(i);
    PairGradient h = GRADIENTS(pair, displacement);
    mat3 a = add_tet(partial, pair.ta, pair.a.volume, h.a), b = mat3(0.0);
    if (pair.two) b = add_tet(partial, pair.tb, pair.b.volume, h.b);
    vec3 s1 = a * pair.a.b1 + b * pair.b.b2, s2 = a * pair.a.b2 + b * pair.b.b1, x = a * pair.a.b3, y = b * pair.b.b3;
    uvec4 slot = FETCH(pair_slots, i);
    correction[slot.x] = vec4(-(s1 + s2 + x + y), 0.0);
    correction[slot.y] = vec4(s1, 0.0);
    correction[slot.z] = vec4(s2, 0.0);
    correction[slot.w] = vec4(x, 0.0);
    if (pair.two) correction[pair.fifth_slot] = vec4(y, 0.0);
  }
  tet_partials[lane] = partial;
}
