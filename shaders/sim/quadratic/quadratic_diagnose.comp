// Elastic (and viscous) force, energy, J, volume, strain and stress of every quadratic tet after a step, as diagnose_tet
// computes them for linear ones, and what moves at its centroid. J is taken at the points and at the corners, which turn
// inside out first.
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/quadratic_slots.glsl"
#include "sim/quadratic/law.glsl"
#include "sim/elasticity/tet_scalars.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)         // [vertex_count] u [m]
INPUT_VEC4(RestPosition, rest_position)        // [vertex_count] X [m]
INPUT_VEC4(Velocity, velocity)                 // [vertex_count] [m/s]
INPUT_VEC4(Predicted, predicted)               // [vertex_count] w inverse mass, 0 where constrained
INPUT_VEC4(PredictedCentroid, predicted_centroid)          // [quadratic_count] xyz u~ [m], w mass [kg]
OUTPUT(TetPartial, TetPartials, tet_partials)              // [invocations] from first_partial on
OUTPUT(CentroidPartial, CentroidPartials, centroid_partials)  // [invocations]
uniform uint quadratic_count, first_partial;

#define BORNE(v) (FETCH(predicted, v).w > 0.0 ? inertia : vec3(0.0))

// Adds what moves at the centroid of tet e. Returns the share of its inertia that a free middle bears.
vec3 add_centroid(inout CentroidPartial partial, uint e) {
  uvec4 a = FETCH(mid_edges, 2u * e), b = FETCH(mid_edges, 2u * e + 1u);
  uint middle[6] = uint[6](a.x, a.y, a.z, a.w, b.x, b.y);
  vec4 center = FETCH(predicted_centroid, e);
  vec3 lag = vec3(0.0), place = vec3(0.0), speed = vec3(0.0);
  float free = 0.0;
  for (int k = 0; k < 6; ++k) {
    uint v = middle[k];
    vec3 u = FETCH(displacement, v).xyz;
    lag += (u - center.xyz) / 6.0;
    place += (FETCH(rest_position, v).xyz + u) / 6.0;
    speed += FETCH(velocity, v).xyz / 6.0;
    if (FETCH(predicted, v).w > 0.0) free += 1.0;
  }
  partial.angular += center.w * vec4(cross(place, speed), 0.5 * dot(speed, speed));
  partial.inertia.xyz += free / 6.0 * center.w * (lag / (SUBSTEP * SUBSTEP) + GRAVITY);
  return center.w / 6.0 * lag;
}

void main() {
  ITEM_OR_RETURN(lane)
  CentroidPartial centroids = CentroidPartial(vec4(0.0), vec4(0.0));
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
    vec3 inertia = add_centroid(centroids, e);
    uvec4 m = FETCH(mid_edges, 2u * e), n = FETCH(mid_edges, 2u * e + 1u);
    uvec4 slot = FETCH(quadratic_slots, 3u * e), slot_1 = FETCH(quadratic_slots, 3u * e + 1u), slot_2 = FETCH(quadratic_slots, 3u * e + 2u);
    correction[slot.x] = vec4(scale * f.corner[0], 0.0);
    correction[slot.y] = vec4(scale * f.corner[1], 0.0);
    correction[slot.z] = vec4(scale * f.corner[2], 0.0);
    correction[slot.w] = vec4(scale * f.corner[3], 0.0);
    correction[slot_1.x] = vec4(scale * f.middle[0] - BORNE(m.x), 0.0);
    correction[slot_1.y] = vec4(scale * f.middle[1] - BORNE(m.y), 0.0);
    correction[slot_1.z] = vec4(scale * f.middle[2] - BORNE(m.z), 0.0);
    correction[slot_1.w] = vec4(scale * f.middle[3] - BORNE(m.w), 0.0);
    correction[slot_2.x] = vec4(scale * f.middle[4] - BORNE(n.x), 0.0);
    correction[slot_2.y] = vec4(scale * f.middle[5] - BORNE(n.y), 0.0);
  }
  tet_partials[first_partial + lane] = partial;
  centroid_partials[lane] = centroids;
}
