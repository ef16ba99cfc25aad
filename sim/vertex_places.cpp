#include "sim/vertex_places.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace fascia {

using Eigen::Vector3d;

std::vector<std::uint32_t> first_at_place(const std::vector<Vector3d>& positions) {
  std::vector<std::uint32_t> order(positions.size()), first(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t v) { return std::array<double, 3>{positions[v].x(), positions[v].y(), positions[v].z()}; };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

std::size_t count_coincident(const std::vector<Vector3d>& positions, const std::vector<Tet>& tets) {
  std::vector<char> used(positions.size(), 0), taken(positions.size(), 0);
  for (const Tet& tet : tets)
    for (const std::uint32_t v : tet) used[v] = 1;
  const std::vector<std::uint32_t> first = first_at_place(positions);
  std::size_t count = 0;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    count += static_cast<std::size_t>(taken[first[v]]);
    taken[first[v]] = 1;
  }
  return count;
}

std::size_t weld(TetMesh& mesh) {
  const std::vector<std::uint32_t> first = first_at_place(mesh.positions);
  std::vector<std::uint32_t> place(first.size());  // in the welded mesh
  std::uint32_t kept = 0;
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    const bool stays = first[v] == v;
    place[v] = stays ? kept++ : place[first[v]];
    if (stays) mesh.positions[place[v]] = mesh.positions[v];
  }
  mesh.positions.resize(kept);
  for (Tet& tet : mesh.tets)
    for (std::uint32_t& v : tet) v = place[v];
  for (auto& [name, vertices] : mesh.groups) {
    for (std::uint32_t& v : vertices) v = place[v];
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }
  return first.size() - kept;
}

}  // namespace fascia
