#include "sim/contact/tissue/tissue_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <utility>

#include "sim/mesh/linear_tets.h"
#include "sim/mesh/tet_faces.h"

namespace fascia {

std::vector<Triangle> tissue_boundary(const Model& model) {
  return boundary_triangles(linear_tets(model.tets, model.mid_edges, model.rest_positions, 0, model.tets.size()).tets);
}

std::vector<std::uint32_t> bodies_of_vertices(const Model& model) {
  std::vector<std::uint32_t> bodies(model.rest_positions.size(), 0);
  for (std::uint32_t b = 0; b < model.bodies.size(); ++b)
    for (std::uint32_t k = 0; k < model.bodies[b].tet_count; ++k)
      for (const std::uint32_t v : model.element(model.bodies[b].tet_begin + k)) bodies[v] = b;
  return bodies;
}

double area_of(const Model& model, const Triangle& t) {
  const auto& x = model.rest_positions;
  return 0.5 * (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm();
}

std::vector<TissueEdge> tissue_edges(const Model& model, const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> known;
  std::vector<TissueEdge> edges;
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [from, to] = std::minmax(triangles[i][k], triangles[i][(k + 1) % 3]);
      const auto [place, is_new] = known.try_emplace({from, to}, edges.size());
      if (is_new) edges.push_back({from, to, {i, TissueEdge::kNoSide}});
      TissueEdge& edge = edges[place->second];
      if (!is_new) edge.sides[1] = i;
      edge.area += area_of(model, triangles[i]);
    }
  return edges;
}

std::vector<double> tissue_areas(const Model& model, const std::vector<Triangle>& triangles) {
  std::vector<double> areas(model.rest_positions.size(), 0);
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t) areas[v] += area_of(model, t) / 3;
  return areas;
}

double surface_modulus(const Material& material) {
  Material at_most = material;
  at_most.poisson_ratio = std::min(material.poisson_ratio, kLockingPoissonRatio);
  return at_most.lame_lambda() + 2 * at_most.lame_mu();
}

std::vector<double> tissue_stiffness(const Model& model, const std::vector<double>& areas) {
  const std::size_t n = model.rest_positions.size();
  std::vector<double> volume(n, 0), stiffness(n, 0);
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const Tet& tet = model.tets[t];
    const auto& x = model.rest_positions;
    const ElementVertices element = model.element(t);
    const double share =
        signed_volume6(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]) / 6 / static_cast<double>(element.size());
    const Material& material = model.materials[model.tet_material[t]];
    for (const std::uint32_t v : element) {
      volume[v] += share;
      stiffness[v] += share * surface_modulus(material);
    }
  }
  for (std::size_t v = 0; v < n; ++v)
    stiffness[v] = areas[v] > 0 ? (stiffness[v] / volume[v]) * areas[v] / (2 * volume[v]) : 0;
  return stiffness;
}

std::vector<double> tissue_viscosity(const Model& model) {
  std::vector<double> stiffness(model.rest_positions.size(), 0), viscosity(stiffness.size(), 0);
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const Tet& tet = model.tets[t];
    const auto& x = model.rest_positions;
    const Material& material = model.materials[model.tet_material[t]];
    const double share = signed_volume6(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]) * surface_modulus(material);
    for (const std::uint32_t v : model.element(t)) {
      stiffness[v] += share;
      viscosity[v] += share * material.damping;
    }
  }
  for (std::size_t v = 0; v < viscosity.size(); ++v)
    if (stiffness[v] > 0) viscosity[v] /= stiffness[v];
  return viscosity;
}

}  // namespace fascia
