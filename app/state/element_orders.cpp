#include "app/state/element_orders.h"

#include <algorithm>
#include <utility>

namespace fascia {

ElementOrders elements_of(const Scene& scene) {
  ElementOrders orders;
  for (const Body& body : scene.bodies) orders.push_back(body.elements);
  return orders;
}

State with_elements(const State& state, const Model& from, const Model& to) {
  if (from.mid_edges == to.mid_edges && from.rest_positions.size() == to.rest_positions.size()) return state;
  State result = initial_state(to);
  result.time = state.time;
  result.led = state.led;
  for (std::size_t b = 0; b < to.bodies.size(); ++b) {
    const BodyPart &before = from.bodies[b], &after = to.bodies[b];
    for (std::uint32_t v = 0; v < std::min(before.vertex_count, after.vertex_count); ++v) {
      result.displacement[after.vertex_begin + v] = state.displacement[before.vertex_begin + v];
      result.velocity[after.vertex_begin + v] = state.velocity[before.vertex_begin + v];
    }
    const auto lay_between = [](std::vector<Eigen::Vector3d>& values, std::uint32_t vertex, std::uint32_t first,
                                std::uint32_t second) { values[vertex] = 0.5 * (values[first] + values[second]); };
    const bool had = from.is_quadratic(before.tet_begin), has = to.is_quadratic(after.tet_begin);
    for (std::uint32_t t = after.tet_begin; has && !had && t < after.tet_begin + after.tet_count; ++t)
      for (std::size_t m = 0; m < kMidEdgeCorners.size(); ++m) {
        const auto [end_a, end_b] = kMidEdgeCorners[m];
        for (std::vector<Eigen::Vector3d>* values : {&result.displacement, &result.velocity})
          lay_between(*values, to.mid_edges[t][m], to.tets[t][end_a], to.tets[t][end_b]);
      }
  }
  return result;
}

}  // namespace fascia
