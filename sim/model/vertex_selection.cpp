#include "sim/model/vertex_selection.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <set>

#include "base/error.h"
#include "base/suggest.h"
#include "sim/mesh/pieces.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

struct Selector {
  const TetMesh& mesh;
  const std::vector<Tet>& tets;
  const UpAxis up;
  const std::vector<char>& used;
  const std::string& where;

  template <class Predicate>
  std::vector<std::uint32_t> all_where(Predicate&& holds) const {
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
      if (holds(v)) vertices.push_back(v);
    }
    return vertices;
  }

  std::vector<std::uint32_t> operator()(const BoxSelection& box) const {
    return all_where([&](std::uint32_t v) {
      const auto& p = mesh.positions[v].array();
      return (p >= box.min.array()).all() && (p <= box.max.array()).all();
    });
  }
  std::vector<std::uint32_t> operator()(const SphereSelection& sphere) const {
    return all_where([&](std::uint32_t v) { return (mesh.positions[v] - sphere.center).norm() <= sphere.radius; });
  }
  std::vector<std::uint32_t> operator()(const VertexSelection& selection) const {
    std::vector<std::uint32_t> vertices = selection.vertices;
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    if (!vertices.empty() && vertices.back() >= mesh.positions.size()) {
      throw Error(where, "vertex " + std::to_string(vertices.back()) + " does not exist",
                  "expected 0 to " + std::to_string(mesh.positions.size() - 1));
    }
    return vertices;
  }
  std::vector<std::uint32_t> operator()(const GroupSelection& selection) const {
    if (const auto it = mesh.groups.find(selection.group); it != mesh.groups.end()) return it->second;
    std::vector<std::string> names;
    for (const auto& [name, vertices] : mesh.groups) names.push_back(name);
    throw Error(where, "the mesh has no group \"" + selection.group + "\"" + perhaps(selection.group, names),
                names.empty() ? "expected a mesh with groups" : "expected one of " + join(names));
  }
  std::vector<std::uint32_t> operator()(const LowestSelection& lowest) const {
    const Vector3d away = (lowest.highest ? -1 : 1) * direction(up);  // from the end that is selected
    const auto height = [&](std::uint32_t v) { return away.dot(mesh.positions[v]); };
    const std::vector<std::uint32_t> piece =
        lowest.each_piece ? pieces_of(tets, used.size()) : std::vector<std::uint32_t>(used.size(), 0);
    std::map<std::uint32_t, std::vector<double>> heights;
    for (std::uint32_t v = 0; v < used.size(); ++v)
      if (used[v]) heights[piece[v]].push_back(height(v));
    std::map<std::uint32_t, double> limits;
    for (auto& [number, values] : heights) limits[number] = limit_of(std::move(values), lowest.share);
    return all_where([&](std::uint32_t v) { return used[v] && height(v) <= limits.at(piece[v]); });
  }

  static double limit_of(std::vector<double> heights, double share) {
    const auto [bottom, top] = std::minmax_element(heights.begin(), heights.end());
    double limit = *bottom + share * (*top - *bottom);
    // A tip or an edge would be a hinge around which the body topples: at least as many vertices as the share states
    // are selected.
    if (const auto least = static_cast<std::size_t>(share * static_cast<double>(heights.size())); least > 0) {
      std::nth_element(heights.begin(), heights.begin() + static_cast<std::ptrdiff_t>(least - 1), heights.end());
      limit = std::max(limit, heights[least - 1]);
    }
    return limit;
  }
};

/// "613 vertices, from (0, -0.05, -0.05) to (0.4, 0.05, 0.05)".
std::string extent_of(const TetMesh& mesh, const std::vector<char>& used, const char* noun) {
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::max()), high = -low;
  std::size_t count = 0;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    ++count;
    low = low.cwiseMin(mesh.positions[v]);
    high = high.cwiseMax(mesh.positions[v]);
  }
  char text[200];
  std::snprintf(text, sizeof text, "%zu %s, from (%g, %g, %g) to (%g, %g, %g)", count, noun, low.x(), low.y(), low.z(),
                high.x(), high.y(), high.z());
  return text;
}

}  // namespace

std::vector<char> used_vertices(const std::vector<Tet>& tets, std::size_t vertex_count) {
  std::vector<char> used(vertex_count, 0);
  for (const Tet& tet : tets) {
    for (const std::uint32_t v : tet) used[v] = 1;
  }
  return used;
}

std::vector<std::uint32_t> select_vertices(const Selection& selection, const SelectableMesh& body,
                                           const std::string& where) {
  const std::vector<char> used = used_vertices(body.tets, body.mesh.positions.size());
  std::vector<std::uint32_t> vertices = std::visit(Selector{body.mesh, body.tets, body.up, used, where}, selection);
  if (std::any_of(vertices.begin(), vertices.end(), [&](std::uint32_t v) { return used[v]; })) return vertices;
  std::set<std::uint32_t> middles;
  for (const MidEdges& of_tet : body.mid_edges) middles.insert(of_tet.begin(), of_tet.end());
  const auto of_edges = std::count_if(vertices.begin(), vertices.end(), [&](auto v) { return middles.contains(v); });
  std::string found = "selects nothing";
  if (of_edges > 0)
    found = "selects no corner of a tet, only vertices in the middles of edges (" + std::to_string(of_edges) + ")";
  else if (!vertices.empty())
    found = "selects no vertex of a tet (" + std::to_string(vertices.size()) + " unused)";
  throw Error(where, found,
              "expected some of the " + extent_of(body.mesh, used, of_edges > 0 ? "corners" : "vertices"));
}

}  // namespace fascia
