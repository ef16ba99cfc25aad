#include "sim/ordering/mesh_order.h"

#include <algorithm>
#include <numeric>

#include "sim/ordering/morton_order.h"

namespace fascia {

MeshOrder mesh_order_of(const Model& model) {
  constexpr std::uint32_t kNone = ~0u;
  const std::size_t count = model.rest_positions.size();
  MeshOrder placement{paired_tets(model), {}, std::vector<std::uint32_t>(count, kNone)};
  placement.vertex.reserve(count);
  const auto meet = [&](std::uint32_t v) {
    if (placement.place[v] != kNone) return;
    placement.place[v] = static_cast<std::uint32_t>(placement.vertex.size());
    placement.vertex.push_back(v);
  };
  const TetPairing& tets_by_pair = placement.tets;
  for (std::size_t i = 0; i < tets_by_pair.second_begin(); ++i) {
    for (const std::uint32_t v : model.tets[tets_by_pair.order[i]]) meet(v);
    if (i >= tets_by_pair.pair_count) continue;
    for (const std::uint32_t v : model.tets[tets_by_pair.order[tets_by_pair.second_begin() + i]]) meet(v);
  }
  for (std::size_t i = tets_by_pair.linear_count(); i < tets_by_pair.order.size(); ++i)
    for (const std::uint32_t v : model.element(tets_by_pair.order[i])) meet(v);
  for (std::uint32_t v = 0; v < count; ++v) meet(v);
  // Neighboring invocations take as long as the one with the most tets: among neighbors, vertices with equal numbers of
  // tets are adjacent.
  constexpr std::size_t kNeighbors = 128;
  std::vector<std::uint32_t> tets(count, 0);
  for (const std::uint32_t t : placement.tets.order)
    for (const std::uint32_t v : model.element(t)) ++tets[v];
  for (std::size_t begin = 0; begin < count; begin += kNeighbors)
    std::stable_sort(placement.vertex.begin() + static_cast<std::ptrdiff_t>(begin),
                     placement.vertex.begin() + static_cast<std::ptrdiff_t>(std::min(begin + kNeighbors, count)),
                     [&](std::uint32_t a, std::uint32_t b) { return tets[a] > tets[b]; });
  for (std::uint32_t k = 0; k < count; ++k) placement.place[placement.vertex[k]] = k;
  return placement;
}

MeshOrder unmoved(const Model& model) {
  std::vector<std::uint32_t> all(model.rest_positions.size());
  std::iota(all.begin(), all.end(), 0u);
  return {paired_tets(model), all, all};
}

Model placed(const Model& model, const MeshOrder& placement) {
  const auto by_place = [&](const std::vector<Eigen::Vector3d>& values) {
    std::vector<Eigen::Vector3d> moved;
    moved.reserve(values.size());
    for (const std::uint32_t v : placement.vertex) moved.push_back(values[v]);
    return moved;
  };
  const auto to_places = [&](auto& vertices) {
    for (std::uint32_t& v : vertices) v = placement.place[v];
  };
  Model result;
  result.rest_positions = by_place(model.rest_positions);
  result.tets = model.tets;
  for (Tet& tet : result.tets) to_places(tet);
  result.mid_edges = model.mid_edges;
  for (MidEdges& mid_edges : result.mid_edges)
    if (mid_edges != kNoMidEdges) to_places(mid_edges);
  result.tet_material = model.tet_material;
  result.materials = model.materials;
  result.fixed = model.fixed;
  to_places(result.fixed);
  std::sort(result.fixed.begin(), result.fixed.end());
  result.motions = model.motions;
  for (Motion& motion : result.motions) to_places(motion.vertices);
  result.initial_velocity = by_place(model.initial_velocity);
  result.gravity = model.gravity;
  result.tools = model.tools;
  result.contact = model.contact;
  return result;
}

}  // namespace fascia
