#include "sim/contact/contact_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include "sim/mesh/linear_tets.h"
#include "sim/mesh/tet_faces.h"
#include "sim/tool/shape_distance.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

// The penalty in motion: in single steps 1 and 100 do as well, but a softer one lets tools sink in deeper, and a harder
// one makes every first touch an impact.
constexpr double kStiffness = 10;

// In triangles between vertices: four in a face of a quadratic tet.
std::vector<Triangle> boundary_of(const Model& model) {
  return boundary_triangles(linear_tets(model.tets, model.mid_edges, model.rest_positions, 0, model.tets.size()).tets);
}

double area_of(const Model& model, const Triangle& t) {
  const auto& x = model.rest_positions;
  return 0.5 * (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm();
}

double longest_edge(const Model& model, const std::vector<Triangle>& triangles) {
  double longest = 0;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, (model.rest_positions[t[k]] - model.rest_positions[t[(k + 1) % 3]]).norm());
  return longest;
}

struct Edge {
  std::uint32_t from, to;
  double area = 0;  // of the triangles at it
};

// In the order of the triangles.
std::vector<Edge> edges_of(const Model& model, const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> known;
  std::vector<Edge> edges;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [from, to] = std::minmax(t[k], t[(k + 1) % 3]);
      const auto [place, is_new] = known.try_emplace({from, to}, edges.size());
      if (is_new) edges.push_back({from, to});
      edges[place->second].area += area_of(model, t);
    }
  return edges;
}

class PointList {
 public:
  PointList(const Model& model, std::vector<ContactPoint>& points) : held_(model.held()), points_(points) {}

  void add(std::array<std::uint32_t, 3> vertices, std::array<double, 3> weights, double area) {
    // A free vertex comes first: it carries the energy of the point.
    for (std::size_t k = 0; k < 3; ++k)
      if (weights[k] > 0 && !held_[vertices[k]]) {
        std::swap(vertices[0], vertices[k]);
        std::swap(weights[0], weights[k]);
        for (std::size_t unused = 1; unused < 3; ++unused)
          if (weights[unused] == 0) vertices[unused] = vertices[0];
        points_.push_back({vertices, weights, area});
        return;
      }
  }

 private:
  std::vector<char> held_;
  std::vector<ContactPoint>& points_;
};

std::vector<double> areas_of(const Model& model, const std::vector<Triangle>& triangles) {
  std::vector<double> area(model.rest_positions.size(), 0);
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t) area[v] += area_of(model, t) / 3;
  return area;
}

void add_vertices(const Model& model, const std::vector<Triangle>& triangles, PointList& list) {
  const std::vector<double> area = areas_of(model, triangles);
  for (std::uint32_t v = 0; v < area.size(); ++v)
    if (area[v] > 0) list.add({v, v, v}, {1, 0, 0}, area[v]);
}

void add_level(int level, const Model& model, const std::vector<Triangle>& triangles, const std::vector<Edge>& edges,
               PointList& list) {
  const int parts = 1 << level;
  for (const Edge& e : edges)
    for (int i = 1; i < parts; i += 2) {
      const double share = static_cast<double>(i) / parts;
      list.add({e.from, e.to, e.from}, {1 - share, share, 0}, e.area);
    }
  for (const Triangle& t : triangles)
    for (int i = 1; i < parts; ++i)
      for (int j = 1; i + j < parts; ++j) {
        if (i % 2 == 0 && j % 2 == 0) continue;  // of a lower level
        list.add(t,
                 {static_cast<double>(i) / parts, static_cast<double>(j) / parts,
                  static_cast<double>(parts - i - j) / parts},
                 2 * area_of(model, t));
      }
}

std::string note_on(const Tool& tool, double spacing, double radius) {
  char text[160];
  std::snprintf(text, sizeof text, ": contact points are %.3g m apart, and parts of %.3g m may pass between them",
                spacing, radius);
  return tool.name + text;
}

}  // namespace

ContactSurface make_contact_surface(const Model& model) {
  ContactSurface surface;
  if (model.tools.empty()) return surface;
  const std::vector<Triangle> triangles = boundary_of(model);
  const double longest = longest_edge(model, triangles);
  std::vector<int> levels;
  for (const Tool& tool : model.tools) {
    const double radius = finest_radius(tool.shape);
    int level = 0;
    while (level < ContactSurface::kFinestLevel && longest / (1 << level) > radius / 2) ++level;
    const double spacing = longest / (1 << level);
    if (spacing > 2 * radius) surface.notes.push_back(note_on(tool, spacing, radius));
    levels.push_back(level);
  }
  const int finest = *std::max_element(levels.begin(), levels.end());
  const std::vector<Edge> edges = finest > 0 ? edges_of(model, triangles) : std::vector<Edge>();
  PointList list(model, surface.points);
  std::array<std::uint32_t, ContactSurface::kFinestLevel + 1> count{};
  for (int level = 0; level <= finest; ++level) {
    if (level == 0)
      add_vertices(model, triangles, list);
    else
      add_level(level, model, triangles, edges, list);
    count[static_cast<std::size_t>(level)] = static_cast<std::uint32_t>(surface.points.size());
  }
  for (std::uint32_t t = 0; t < model.tools.size(); ++t)
    for (std::uint32_t piece = 0; piece < model.tools[t].piece_count(); ++piece) {
      const std::uint32_t points = count[static_cast<std::size_t>(levels[t])];
      surface.pieces.push_back({t, piece, levels[t], points, surface.row_count});
      surface.row_count += points;
    }
  return surface;
}

std::vector<double> surface_areas(const Model& model) { return areas_of(model, boundary_of(model)); }

std::vector<double> contact_stiffness(const Model& model, const ContactSurface& surface) {
  const std::size_t n = model.rest_positions.size();
  std::vector<double> volume(n, 0), modulus(n, 0), area = surface_areas(model);
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const Tet& tet = model.tets[t];
    const auto& x = model.rest_positions;
    const ElementVertices element = model.element(t);
    const double share =
        signed_volume6(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]) / 6 / static_cast<double>(element.size());
    const Material& material = model.materials[model.tet_material[t]];
    for (const std::uint32_t v : element) {
      volume[v] += share;
      modulus[v] += share * (material.lame_lambda() + 2 * material.lame_mu());
    }
  }
  std::vector<double> stiffness;
  stiffness.reserve(surface.points.size());
  for (const ContactPoint& point : surface.points) {
    double per_area = 0;  // (lambda + 2 mu) / l [Pa/m]
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = point.vertices[k];
      if (point.weights[k] > 0) per_area += point.weights[k] * (modulus[v] / volume[v]) * area[v] / (2 * volume[v]);
    }
    stiffness.push_back(kStiffness * model.contact.stiffness * per_area * point.area);
  }
  return stiffness;
}

}  // namespace fascia
