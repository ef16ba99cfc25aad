// Elastic (and viscous) force, energy, J, volume, strain and stress of every tet after a step. Each invocation walks through every
// invocations-th tet and keeps its own sums: deterministic on every device.
// Writes h^2 times the force on each corner into the slots for diagnose_vertex, and one TetPartial per invocation.
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/tet.glsl"
#include "sim/elasticity.glsl"
#include "sim/tet_scalars.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]
INPUT_UVEC4(TetSlots, tet_slots)        // [tet_count]
OUTPUT(vec4, Correction, correction)    // [4 * tet_count] -h^2 V P b_a [kg m]
OUTPUT(TetPartial, TetPartials, tet_partials)  // [invocations]
uniform uint tet_count;

void main() {
  ITEM_OR_RETURN(i)
  TetPartial partial = TetPartial(vec4(3.4e38, -3.4e38, 0.0, 0.0), vec4(0.0));
  FOR_ITEMS_OF_LANE(t, i, invocations, tet_count) {
    Tet tet = load_tet(t);
    mat3 h = displacement_gradient(tet, FETCH(displacement, tet.v.x).xyz, FETCH(displacement, tet.v.y).xyz,
                                   FETCH(displacement, tet.v.z).xyz, FETCH(displacement, tet.v.w).xyz);
    vec4 material = material_of(t);
    Elastic elastic = elastic_of(h, material);
    mat3 p = response_of(t, h, material).p;
    float scale = -SUBSTEP * SUBSTEP * tet.volume;
    vec3 f1 = scale * (p * tet.b1), f2 = scale * (p * tet.b2), f3 = scale * (p * tet.b3);
    uvec4 slot = FETCH(tet_slots, t);
    correction[slot.x] = vec4(-(f1 + f2 + f3), 0.0);
    correction[slot.y] = vec4(f1, 0.0);
    correction[slot.z] = vec4(f2, 0.0);
    correction[slot.w] = vec4(f3, 0.0);

    float growth = det_f_minus_one(h), j = 1.0 + growth;
    float strain = strain_norm(green_strain(h));
    partial.range = vec4(min(partial.range.x, j), max(partial.range.y, j), max(partial.range.z, strain),
                         max(partial.range.w, von_mises_stress(mat3(1.0) + h, j, elastic.p)));
    partial.sums += tet.volume * vec4(elastic.energy, 0.0, growth, strain * strain);
    partial.sums.y += j <= 0.0 ? 1.0 : 0.0;
  }
  tet_partials[i] = partial;
}
