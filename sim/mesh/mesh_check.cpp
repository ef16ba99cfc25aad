#include "sim/mesh/mesh_check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>

#include "sim/mesh/tet_faces.h"
#include "sim/mesh/vertex_check.h"

namespace fascia {
namespace {

constexpr double kSliverDeg = 5;

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t find(std::uint32_t item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }
  /// True if a and b were separate before.
  bool join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[b] = a;
    return a != b;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

struct TetShape {
  double volume, shortest_edge2, longest_edge2;
  double largest_cosine,
      smallest_cosine;  // of the six dihedral angles: of the smallest angle and of the largest
};

TetShape measure(const TetMesh& mesh, const Tet& tet) {
  const Eigen::Vector3d &a = mesh.positions[tet[0]], &b = mesh.positions[tet[1]], &c = mesh.positions[tet[2]],
                        &d = mesh.positions[tet[3]];
  TetShape shape{signed_volume6(a, b, c, d) / 6, 0, 0, -1, 1};
  const double edges2[6] = {(b - a).squaredNorm(), (c - a).squaredNorm(), (d - a).squaredNorm(),
                            (c - b).squaredNorm(), (d - b).squaredNorm(), (d - c).squaredNorm()};
  shape.shortest_edge2 = *std::min_element(edges2, edges2 + 6);
  shape.longest_edge2 = *std::max_element(edges2, edges2 + 6);
  const Eigen::Vector3d normals[4] = {(c - b).cross(d - b).normalized(), (d - a).cross(c - a).normalized(),
                                      (b - a).cross(d - a).normalized(), (c - a).cross(b - a).normalized()};
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      const double cosine = std::clamp(-normals[i].dot(normals[j]), -1.0, 1.0);
      shape.largest_cosine = std::max(shape.largest_cosine, cosine);
      shape.smallest_cosine = std::min(shape.smallest_cosine, cosine);
    }
  }
  return shape;
}

double degrees(double cosine) { return std::acos(cosine) * 180 / std::numbers::pi; }

void examine_tets(const TetMesh& mesh, const MeshRepair& repaired, MeshReport& report) {
  std::map<int, MeshReport::Region> regions;
  double shortest2 = std::numeric_limits<double>::infinity(), longest2 = 0, largest_cosine = -1, smallest_cosine = 1;
  const double sliver_cosine = std::cos(kSliverDeg * std::numbers::pi / 180);
  std::vector<MeshReport::Sliver> slivers;
  for (std::size_t t = 0; t < repaired.tets.size(); ++t) {
    const TetShape shape = measure(mesh, repaired.tets[t]);
    const std::uint32_t source = repaired.source[t];
    report.volume += shape.volume;
    shortest2 = std::min(shortest2, shape.shortest_edge2);
    longest2 = std::max(longest2, shape.longest_edge2);
    largest_cosine = std::max(largest_cosine, shape.largest_cosine);
    smallest_cosine = std::min(smallest_cosine, shape.smallest_cosine);
    if (shape.largest_cosine > sliver_cosine) slivers.push_back({source, degrees(shape.largest_cosine)});
    const int number = mesh.regions[source];
    MeshReport::Region& region = regions.try_emplace(number, MeshReport::Region{number, "", 0, 0}).first->second;
    ++region.tets;
    region.volume += shape.volume;
  }
  if (repaired.tets.empty()) return;
  report.shortest_edge = std::sqrt(shortest2);
  report.longest_edge = std::sqrt(longest2);
  report.smallest_dihedral_deg = degrees(largest_cosine);
  report.largest_dihedral_deg = degrees(smallest_cosine);
  report.slivers = slivers.size();
  std::stable_sort(slivers.begin(), slivers.end(), [](const MeshReport::Sliver& a, const MeshReport::Sliver& b) {
    return a.smallest_dihedral_deg < b.smallest_dihedral_deg;
  });
  slivers.resize(std::min(slivers.size(), kNamedTets));
  report.worst_slivers = slivers;
  for (auto& [number, region] : regions) {
    if (const auto name = mesh.region_names.find(number); name != mesh.region_names.end()) region.name = name->second;
    report.regions.push_back(region);
  }
}

void examine_vertices(const TetMesh& mesh, const std::vector<Tet>& tets, MeshReport& report) {
  std::vector<char> used(mesh.positions.size(), 0);
  DisjointSets sets(mesh.positions.size());
  std::size_t joins = 0, used_count = 0;
  for (const Tet& tet : tets) {
    for (const std::uint32_t vertex : tet) {
      used[vertex] = 1;
      joins += sets.join(tet[0], vertex);
    }
  }
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    const Eigen::Vector3d& position = mesh.positions[v];
    report.box_min = used_count == 0 ? position : report.box_min.cwiseMin(position);
    report.box_max = used_count == 0 ? position : report.box_max.cwiseMax(position);
    ++used_count;
  }
  report.unused_vertices = used.size() - used_count;
  report.components = used_count - joins;
  report.coincident_vertices = count_coincident(mesh.positions, tets);
}

/// A surface is manifold when each edge joins two triangles and the triangles around each vertex form one fan. Corners
/// of triangles are joined across every good edge; the fans of a vertex are the sets that remain separate.
void examine_boundary(const std::vector<Triangle>& triangles, std::size_t vertex_count, MeshReport& report) {
  struct Edge {
    std::uint32_t low, high;
    std::uint32_t low_corner, high_corner;  // 3 * triangle + corner
    bool same_vertices(const Edge& other) const { return low == other.low && high == other.high; }
  };
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  std::vector<std::uint32_t> fans(vertex_count, 0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      Edge edge{triangles[t][k], triangles[t][next], static_cast<std::uint32_t>(3 * t + k),
                static_cast<std::uint32_t>(3 * t + next)};
      if (edge.low > edge.high) {
        std::swap(edge.low, edge.high);
        std::swap(edge.low_corner, edge.high_corner);
      }
      edges.push_back(edge);
      ++fans[triangles[t][k]];
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
  DisjointSets corners(edges.size());
  for (std::size_t begin = 0, end; begin < edges.size(); begin = end) {
    end = begin + 1;
    while (end < edges.size() && edges[end].same_vertices(edges[begin])) ++end;
    if (end - begin != 2) {
      ++report.nonmanifold_edges;
      continue;
    }
    const Edge &one = edges[begin], &other = edges[begin + 1];
    fans[one.low] -= corners.join(one.low_corner, other.low_corner);
    fans[one.high] -= corners.join(one.high_corner, other.high_corner);
  }
  report.boundary_triangles = triangles.size();
  report.nonmanifold_vertices =
      static_cast<std::size_t>(std::count_if(fans.begin(), fans.end(), [](std::uint32_t count) { return count > 1; }));
  report.boundary_manifold = !triangles.empty() && report.nonmanifold_edges == 0 && report.nonmanifold_vertices == 0;
}

}  // namespace

MeshReport examine(const TetMesh& mesh, const MeshRepair& repaired) {
  MeshReport report;
  report.vertex_count = mesh.positions.size();
  report.tet_count = mesh.tets.size();
  report.usable_tets = repaired.tets.size();
  report.flipped = repaired.flipped.size();
  report.degenerate = repaired.degenerate.size();
  report.duplicated = repaired.duplicated.size();
  report.far_vertices = far_vertices(mesh);
  examine_tets(mesh, repaired, report);
  examine_vertices(mesh, repaired.tets, report);
  examine_boundary(boundary_triangles(repaired.tets), mesh.positions.size(), report);
  report.unit_guess = guess_unit((report.box_max - report.box_min).maxCoeff());
  return report;
}

}  // namespace fascia
