// Elastic (and viscous) force, energy, J, strain and stress of every tet after a step. Each invocation walks through every
// invocations-th tet and keeps its own sums: deterministic on every device.
// Writes h^2 times the force on each corner into the slots for diagnose_vertex, and one TetPartial per invocation.
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/symmetric.glsl"
#include "common/tet.glsl"
#include "sim/feature_material.glsl"
#include "sim/feature_damping.glsl"
#include "sim/material/st_venant_kirchhoff.glsl"
#include "sim/tet_scalars.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]
INPUT_UVEC4(TetSlots, tet_slots)        // [tet_count]
OUTPUT(vec4, Correction, correction)    // [4 * tet_count] -h^2 V F S b_a [kg m]
OUTPUT(TetPartial, TetPartials, tet_partials)  // [invocations]
uniform uint tet_count;

void main() {
  ITEM_OR_RETURN(i)
  TetPartial partial = TetPartial(vec4(3.4e38, -3.4e38, 0.0, 0.0), vec4(0.0));
  for (uint t = i; t < tet_count; t += invocations) {
    Tet tet = load_tet(t);
    mat3 h = displacement_gradient(tet, FETCH(displacement, tet.v.x).xyz, FETCH(displacement, tet.v.y).xyz,
                                   FETCH(displacement, tet.v.z).xyz, FETCH(displacement, tet.v.w).xyz);
    mat3 f = mat3(1.0) + h;
    Sym3 e = green_strain(h);
    vec4 material = material_of(t);
    float damping = damping_over_h(material);
    Sym3 before = previous_strain_of(t);
    Sym3 elastic = second_piola_stress(e, material);
    Sym3 s = second_piola_stress(Sym3(e.d + damping * (e.d - before.d), e.s + damping * (e.s - before.s)), material);
    float scale = -SUBSTEP * SUBSTEP * tet.volume;
    vec3 f1 = scale * (f * times(s, tet.b1)), f2 = scale * (f * times(s, tet.b2)), f3 = scale * (f * times(s, tet.b3));
    uvec4 slot = FETCH(tet_slots, t);
    correction[slot.x] = vec4(-(f1 + f2 + f3), 0.0);
    correction[slot.y] = vec4(f1, 0.0);
    correction[slot.z] = vec4(f2, 0.0);
    correction[slot.w] = vec4(f3, 0.0);

    float j = 1.0 + det_f_minus_one(h);
    float energy = 0.5 * tet.volume * contract(elastic, e);
    bool finite = !(isnan(j) || isinf(j) || isnan(energy) || isinf(energy));
    float strain = strain_norm(e);
    partial.range = vec4(min(partial.range.x, j), max(partial.range.y, j), max(partial.range.z, strain),
                         max(partial.range.w, von_mises_stress(f, j, elastic)));
    partial.sums += vec4(energy, j <= 0.0 ? 1.0 : 0.0, finite ? 0.0 : 1.0, tet.volume * strain * strain);
  }
  tet_partials[i] = partial;
}
