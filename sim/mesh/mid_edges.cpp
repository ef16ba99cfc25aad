#include "sim/mesh/mid_edges.h"

#include <algorithm>
#include <unordered_map>

namespace fascia {
namespace {

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
}

}  // namespace

void add_mid_edges(TetMesh& mesh, const std::vector<std::uint32_t>& tets, const std::vector<MidEdges>& given) {
  mesh.mid_edges.assign(mesh.tets.size(), kNoMidEdges);
  std::unordered_map<std::uint64_t, std::uint32_t> vertex_of;
  vertex_of.reserve(2 * mesh.tets.size());
  const auto for_edges = [&](auto&& use) {
    for (const std::uint32_t t : tets)
      for (std::size_t m = 0; m < kMidEdgeCorners.size(); ++m)
        use(t, m, mesh.tets[t][kMidEdgeCorners[m][0]], mesh.tets[t][kMidEdgeCorners[m][1]]);
  };
  if (!given.empty())
    for_edges([&](std::uint32_t t, std::size_t m, std::uint32_t a, std::uint32_t b) {
      const std::uint32_t vertex = t < given.size() ? given[t][m] : kNoVertex;
      if (vertex != kNoVertex) vertex_of.try_emplace(key_of(a, b), vertex);
    });
  for_edges([&](std::uint32_t t, std::size_t m, std::uint32_t a, std::uint32_t b) {
    const auto next = static_cast<std::uint32_t>(mesh.positions.size());
    const auto [edge, is_new] = vertex_of.try_emplace(key_of(a, b), next);
    if (is_new) mesh.positions.emplace_back(0.5 * (mesh.positions[a] + mesh.positions[b]));
    mesh.mid_edges[t][m] = edge->second;
  });
}

std::size_t straighten(TetMesh& mesh) {
  std::size_t curved = 0;
  for (const MidEdge& edge : mid_edges_of(mesh)) {
    Eigen::Vector3d& x = mesh.positions[edge.vertex];
    const Eigen::Vector3d &a = mesh.positions[edge.a], &b = mesh.positions[edge.b], middle = 0.5 * (a + b);
    curved += (x - middle).norm() > 1e-6 * (b - a).norm();
    x = middle;
  }
  return curved;
}

std::vector<MidEdge> mid_edges_of(const TetMesh& mesh) {
  std::vector<MidEdge> edges;
  std::vector<char> met(mesh.positions.size(), 0);
  for (std::size_t t = 0; t < mesh.mid_edges.size(); ++t)
    for (std::size_t m = 0; m < kMidEdgeCorners.size(); ++m) {
      const std::uint32_t vertex = mesh.mid_edges[t][m];
      if (vertex == kNoVertex || met[vertex]) continue;
      met[vertex] = 1;
      edges.push_back({vertex, mesh.tets[t][kMidEdgeCorners[m][0]], mesh.tets[t][kMidEdgeCorners[m][1]]});
    }
  return edges;
}

MidEdges reordered(const MidEdges& mid_edges, const Tet& from, const Tet& to) {
  MidEdges result = kNoMidEdges;
  for (std::size_t m = 0; m < kMidEdgeCorners.size(); ++m) {
    const std::uint64_t edge = key_of(to[kMidEdgeCorners[m][0]], to[kMidEdgeCorners[m][1]]);
    for (std::size_t n = 0; n < kMidEdgeCorners.size(); ++n)
      if (key_of(from[kMidEdgeCorners[n][0]], from[kMidEdgeCorners[n][1]]) == edge) result[m] = mid_edges[n];
  }
  return result;
}

}  // namespace fascia
