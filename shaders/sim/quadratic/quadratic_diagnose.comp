// Elastic (and viscous) force, energy, J, volume, strain and stress of every quadratic tet after a step, as diagnose_tet
// computes them for linear ones. J is taken at the points and at the corners, which turn inside out first.
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/quadratic_slots.glsl"
#include "sim/quadratic/law.glsl"
#include "sim/elasticity/tet_scalars.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)         // [vertex_count] u [m]
OUTPUT(TetPartial, TetPartials, tet_partials)  // [invocations] from first_partial on
uniform uint quadratic_count, first_partial;

void main() {
  ITEM_OR_RETURN(lane)
  TetPartial partial = TetPartial(vec4(3.4e38, -3.4e38, 0.0, 0.0), vec4(0.0));
  FOR_ITEMS_OF_LANE(e, lane, invocations, quadratic_count) {
    uint t = FIRST_QUADRATIC + e;
    Tet tet = load_tet(t);
    vec4 material = material_of(t);
    PointGradients corners = CORNER_GRADIENTS(e, tet, displacement), h = at_points(corners);
    float smallest = 3.4e38, largest = -3.4e38, growth = 0.0, squares = 0.0;
    for (int q = 0; q < 4; ++q) {
      float at_corner = det_f_minus_one(PICK(corners, q));
      smallest = min(smallest, 1.0 + at_corner);
      largest = max(largest, 1.0 + at_corner);
    }
    QuadraticLaw law = law_of(e, h, material);
    float energy = energy_of_mean(law);
    for (int q = 0; q < 4; ++q) {
      mat3 point = PICK(h, q);
      Elastic elastic = elastic_at(law, point, material);
      energy += 0.25 * elastic.energy;
      float at_point = det_f_minus_one(point);
      smallest = min(smallest, 1.0 + at_point);
      largest = max(largest, 1.0 + at_point);
      growth += 0.25 * at_point;
      float strain = strain_norm(green_strain(point));
      squares += 0.25 * strain * strain;
      partial.range.z = max(partial.range.z, strain);
      partial.range.w = max(partial.range.w, von_mises_stress(mat3(1.0) + point, 1.0 + at_point, elastic.p));
    }
    partial.range.x = min(partial.range.x, smallest);
    partial.range.y = max(partial.range.y, largest);
    partial.sums += tet.volume * vec4(energy, 0.0, growth, squares);
    partial.sums.y += smallest <= 0.0 ? 1.0 : 0.0;
    respond(e, h, material);
    QuadraticForces f = forces_of(tet, h);  // by now, the stresses
    float scale = -SUBSTEP * SUBSTEP * tet.volume;
    uvec4 slot = FETCH(quadratic_slots, 3u * e), slot_1 = FETCH(quadratic_slots, 3u * e + 1u), slot_2 = FETCH(quadratic_slots, 3u * e + 2u);
    correction[slot.x] = vec4(scale * f.corner[0], 0.0);
    correction[slot.y] = vec4(scale * f.corner[1], 0.0);
    correction[slot.z] = vec4(scale * f.corner[2], 0.0);
    correction[slot.w] = vec4(scale * f.corner[3], 0.0);
    correction[slot_1.x] = vec4(scale * f.middle[0], 0.0);
    correction[slot_1.y] = vec4(scale * f.middle[1], 0.0);
    correction[slot_1.z] = vec4(scale * f.middle[2], 0.0);
    correction[slot_1.w] = vec4(scale * f.middle[3], 0.0);
    correction[slot_2.x] = vec4(scale * f.middle[4], 0.0);
    correction[slot_2.y] = vec4(scale * f.middle[5], 0.0);
  }
  tet_partials[first_partial + lane] = partial;
}
