#include "sim/mesh/vertex_check.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "base/error.h"
#include "base/text.h"

namespace fascia {
namespace {

// Of the length that contains the middle half of the vertices; graded meshes stay well below it
constexpr double kFarLengths = 1e4;

std::vector<char> vertices_of(const std::vector<Tet>& tets, std::size_t vertex_count) {
  std::vector<char> used(vertex_count, 0);
  for (const Tet& tet : tets)
    for (const std::uint32_t v : tet) used[v] = 1;
  return used;
}

}  // namespace

using Eigen::Vector3d;

void require_range(const std::vector<Vector3d>& positions, const std::string& where) {
  constexpr double kMost = std::numeric_limits<float>::max();
  const auto beyond = std::find_if(positions.begin(), positions.end(),
                                   [](const Vector3d& x) { return !(x.cwiseAbs().maxCoeff() <= kMost); });
  if (beyond == positions.end()) return;
  throw Error(where,
              "vertex " + std::to_string(beyond - positions.begin()) + " is at " + point(*beyond) +
                  ", beyond the range of float32",
              "expected coordinates of up to " + number(kMost));
}

std::vector<std::uint32_t> first_at_place(const std::vector<Vector3d>& positions) {
  std::vector<std::uint32_t> order(positions.size()), first(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t v) {
    return std::array<double, 3>{positions[v].x(), positions[v].y(), positions[v].z()};
  };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

std::size_t count_coincident(const std::vector<Vector3d>& positions, const std::vector<Tet>& tets) {
  const std::vector<char> used = vertices_of(tets, positions.size());
  std::vector<char> taken(positions.size(), 0);
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
  for (MidEdges& of_tet : mesh.mid_edges)
    for (std::uint32_t& v : of_tet)
      if (v != kNoVertex) v = place[v];
  for (auto& [name, vertices] : mesh.groups) {
    for (std::uint32_t& v : vertices) v = place[v];
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }
  return first.size() - kept;
}

std::vector<std::uint32_t> far_vertices(const TetMesh& mesh) {
  const std::vector<char> used = vertices_of(mesh.tets, mesh.positions.size());
  Vector3d middle = Vector3d::Zero();
  double length = 0;  // that contains the middle half of the vertices
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> x;
    for (std::size_t v = 0; v < used.size(); ++v)
      if (used[v]) x.push_back(mesh.positions[v][axis]);
    if (x.empty()) return {};
    const auto value = [&](std::size_t quarter) {
      const auto place = x.begin() + static_cast<std::ptrdiff_t>(quarter * x.size() / 4);
      std::nth_element(x.begin(), place, x.end());
      return *place;
    };
    middle[axis] = value(2);
    length = std::max(length, value(3) - value(1));
  }
  std::vector<std::uint32_t> far;
  for (std::uint32_t v = 0; length > 0 && v < used.size(); ++v)
    if (used[v] && (mesh.positions[v] - middle).cwiseAbs().maxCoeff() > kFarLengths * length) far.push_back(v);
  return far;
}

}  // namespace fascia
