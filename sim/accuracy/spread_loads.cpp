#include "sim/accuracy/spread_loads.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <utility>

#include "sim/accuracy/recovered_stress.h"
#include "sim/mesh/tet_faces.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using Vectors = std::vector<Vector3d>;
using Edges = std::vector<std::array<std::uint32_t, 2>>;

/// Accelerations of the inner vertices, and from there on, ring by ring, the means of what is known around.
Vectors field_of(const Vectors& forces, const std::vector<double>& masses, const std::vector<char>& held,
                 const std::vector<char>& surface, const Edges& edges) {
  Vectors field(masses.size(), Vector3d::Zero());
  std::vector<char> known(masses.size());
  const auto take = [&](bool of_surface) {
    for (std::size_t v = 0; v < known.size(); ++v) {
      if (masses[v] == 0 || held[v] || known[v] || (surface[v] && !of_surface)) continue;
      field[v] = forces[v] / masses[v];
      known[v] = 1;
    }
  };
  take(false);
  for (bool thin = false;; thin = true) {
    for (bool grows = true; grows;) {
      Vectors sum(known.size(), Vector3d::Zero());
      std::vector<int> count(known.size());
      for (const auto& [a, b] : edges)
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)})
          if (known[from] && !known[to]) {
            sum[to] += field[from];
            ++count[to];
          }
      grows = false;
      for (std::size_t v = 0; v < known.size(); ++v)
        if (count[v] > 0) {
          field[v] = sum[v] / count[v];
          known[v] = grows = true;
        }
    }
    if (thin) return field;
    take(true);  // parts without inner vertices
  }
}

}  // namespace

Vector3d SpreadLoads::field_at(const Tet& tet, const Eigen::Vector4d& barycentric) const {
  Vector3d at = Vector3d::Zero();
  for (std::size_t a = 0; a < 4; ++a) at += barycentric[static_cast<int>(a)] * field[tet[a]];
  return at;
}

double face_area(const Model& model, const Triangle& face) {
  const Vector3d& x = model.rest_positions[face[0]];
  return 0.5 * (model.rest_positions[face[1]] - x).cross(model.rest_positions[face[2]] - x).norm();
}

SpreadLoads spread_loads(const Model& model, const std::vector<std::uint32_t>& tets, const Edges& edges,
                         const Vectors& forces) {
  const std::vector<char> held = model.held();
  std::vector<double> masses(held.size()), areas(held.size());
  std::vector<char> of_surface(held.size());
  std::vector<Tet> corners;
  for (const std::uint32_t t : tets) {
    corners.push_back(model.tets[t]);
    for (const std::uint32_t v : model.tets[t])
      masses[v] += model.materials[model.tet_material[t]].density * volume_of(model, t) / 4;
  }
  SpreadLoads loads{{}, Vectors(held.size(), Vector3d::Zero()), boundary_triangles(corners)};
  for (const Triangle& face : loads.surface)
    for (const std::uint32_t v : face) {
      of_surface[v] = 1;
      areas[v] += face_area(model, face) / 3;
    }
  loads.field = field_of(forces, masses, held, of_surface, edges);
  for (std::size_t v = 0; v < held.size(); ++v)
    if (of_surface[v] && !held[v]) loads.traction[v] = (forces[v] - masses[v] * loads.field[v]) / areas[v];
  return loads;
}

void add_traction(const Model& model, const std::vector<Triangle>& faces, const std::vector<MidEdge>& edges,
                  const Vectors& traction, double factor, Vectors& forces) {
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> middles;
  for (const MidEdge& edge : edges) middles[{std::min(edge.a, edge.b), std::max(edge.a, edge.b)}] = edge.vertex;
  for (const Triangle& face : faces) {
    const double area = factor * face_area(model, face);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = face[k], b = face[(k + 1) % 3], c = face[(k + 2) % 3];
      forces[a] += area / 60 * (2 * traction[a] - traction[b] - traction[c]);
      forces[middles.at({std::min(a, b), std::max(a, b)})] +=
          area / 15 * (2 * traction[a] + 2 * traction[b] + traction[c]);
    }
  }
}

}  // namespace fascia
