#include "sim/accuracy/refined_model.h"

#include <algorithm>
#include <numeric>

#include "sim/elements/quadratic_tet.h"
#include "sim/mesh/linear_tets.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

/// The displacement of a tet at barycentric coordinates.
Vector3d displacement_in(const ElementVertices& element, const State& state, const Vector4d& at) {
  Vector3d u = Vector3d::Zero();
  if (element.size() == 4) {
    for (std::size_t n = 0; n < 4; ++n) u += at[static_cast<int>(n)] * state.displacement[element[n]];
  } else {
    const QuadraticTet::ShapeFunctions values = QuadraticTet::shape_functions(at);
    for (std::size_t n = 0; n < 10; ++n) u += values[n] * state.displacement[element[n]];
  }
  return u;
}

}  // namespace

Vector4d place_in(const ElementVertices& element, std::uint32_t vertex) {
  const auto n = static_cast<std::size_t>(std::find(element.begin(), element.end(), vertex) - element.begin());
  if (n < 4) return Vector4d::Unit(static_cast<int>(n));
  const auto [a, b] = kMidEdgeCorners[n - 4];
  return 0.5 * (Vector4d::Unit(static_cast<int>(a)) + Vector4d::Unit(static_cast<int>(b)));
}

RefinedModel refined(const Model& coarse, const State& state, ElementOrder kind) {
  const bool cut = kind == ElementOrder::quadratic;
  RefinedModel result;
  TetMesh whole, fine;
  fine.positions = whole.positions = coarse.rest_positions;
  result.first_of.resize(coarse.tets.size());
  result.parts = cut ? 8 : 1;
  for (std::uint32_t t = 0; t < coarse.tets.size(); ++t) {
    if (coarse.is_quadratic(t) != cut) continue;
    result.tets.push_back(t);
    result.first_of[t] = static_cast<std::uint32_t>(fine.tets.size());
    if (cut) {
      whole.tets.push_back(coarse.tets[t]);
      whole.mid_edges.push_back(coarse.mid_edges[t]);
      for (const Tet& tet : cut_in_eight(coarse.tets[t], coarse.mid_edges[t], coarse.rest_positions))
        fine.tets.push_back(tet);
    } else {
      fine.tets.push_back(coarse.tets[t]);
    }
    result.model.tet_material.resize(fine.tets.size(), coarse.tet_material[t]);
  }
  std::vector<std::uint32_t> all(fine.tets.size());
  std::iota(all.begin(), all.end(), 0u);
  add_mid_edges(fine, all);
  if (cut) result.coarse_edges = mid_edges_of(whole);
  result.edges = mid_edges_of(fine);
  result.model.rest_positions = fine.positions;
  result.model.tets = fine.tets;
  result.model.mid_edges = fine.mid_edges;
  result.model.materials = coarse.materials;
  result.held = coarse.held();
  result.held.resize(fine.positions.size());
  for (const MidEdge& edge : result.edges) result.held[edge.vertex] = result.held[edge.a] && result.held[edge.b];
  for (std::uint32_t v = 0; v < result.held.size(); ++v)
    if (result.held[v]) result.model.fixed.push_back(v);
  result.state.displacement = state.displacement;
  result.state.displacement.resize(fine.positions.size());
  for (const std::uint32_t t : result.tets) {
    const ElementVertices element = coarse.element(t);
    for (std::size_t s = result.first_of[t]; s < result.first_of[t] + result.parts; ++s)
      for (std::size_t m = 0; m < 6; ++m) {
        const auto [a, b] = kMidEdgeCorners[m];
        result.state.displacement[fine.mid_edges[s][m]] = displacement_in(
            element, state, 0.5 * (place_in(element, fine.tets[s][a]) + place_in(element, fine.tets[s][b])));
      }
  }
  return result;
}

}  // namespace fascia
