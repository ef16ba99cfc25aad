#include "sim/mesh/mid_edges.h"

#include <algorithm>
#include <unordered_map>

namespace fascia {
namespace {

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
}

}  // namespace

void add_mid_edges(TetMesh& mesh, const std::vector<std::uint32_t>& tets) {
  mesh.mid_edges.resize(mesh.tets.size(), kNoMidEdges);
  std::unordered_map<std::uint64_t, std::uint32_t> vertex_of;
  vertex_of.reserve(2 * mesh.tets.size());
  for (const std::uint32_t t : tets)
    for (std::size_t m = 0; m < kMidEdgeCorners.size(); ++m) {
      const std::uint32_t a = mesh.tets[t][kMidEdgeCorners[m][0]], b = mesh.tets[t][kMidEdgeCorners[m][1]];
      const auto next = static_cast<std::uint32_t>(mesh.positions.size());
      const auto [edge, is_new] = vertex_of.try_emplace(key_of(a, b), next);
      if (is_new) mesh.positions.emplace_back(0.5 * (mesh.positions[a] + mesh.positions[b]));
      mesh.mid_edges[t][m] = edge->second;
    }
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
