// What is gathered over a model or a mesh: masses of vertices, when all motion has ended, and the hash that identifies
// a mesh.
#include <algorithm>
#include <bit>

#include "sim/elements/quadratic_tet.h"
#include "sim/model/model.h"

namespace fascia {

namespace {

double mass_of_tet(const Model& model, std::size_t t) {
  const Tet& tet = model.tets[t];
  const auto& x = model.rest_positions;
  const double volume = signed_volume6(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]) / 6;
  return model.materials[model.tet_material[t]].density * volume;
}

// `of_corner`, `of_middle`: their shares of the mass of a quadratic tet.
std::vector<double> masses_of_vertices(const Model& model, double of_corner, double of_middle) {
  std::vector<double> masses(model.rest_positions.size(), 0.0);
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const double mass = mass_of_tet(model, t);
    const bool quadratic = model.is_quadratic(t);
    const double corner = quadratic ? of_corner * mass : mass / 4;
    for (const std::uint32_t vertex : model.tets[t]) masses[vertex] += corner;
    if (!quadratic) continue;
    for (const std::uint32_t vertex : model.mid_edges[t]) masses[vertex] += of_middle * mass;
  }
  return masses;
}

}  // namespace

std::vector<double> lumped_masses(const Model& model) {
  return masses_of_vertices(model, QuadraticTet::kCornerMass, QuadraticTet::kMidEdgeMass);
}

std::vector<double> consistent_masses(const Model& model) {
  return masses_of_vertices(model, QuadraticTet::kCornerLoad, QuadraticTet::kMidEdgeLoad);
}

MovingMasses moving_masses(const Model& model) {
  MovingMasses masses{masses_of_vertices(model, QuadraticTet::kOwnCornerMass, QuadraticTet::kOwnMidEdgeMass), {}};
  if (!model.has_quadratic()) return masses;
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    masses.centroid.push_back(model.is_quadratic(t) ? QuadraticTet::kCentroidMass * mass_of_tet(model, t) : 0);
  return masses;
}

double Model::end_of_motions() const {
  double end = 0;
  for (const Motion& motion : motions) end = std::max(end, motion.start + motion.duration);
  return end;
}

double Model::end_of_tools() const {
  double end = 0;
  for (const Tool& tool : tools) end = std::max(end, tool.end());
  return end;
}

bool Model::touches_tissue() const { return contact.self || contact.bodies; }
bool Model::has_contact() const { return !tools.empty() || touches_tissue(); }

double Model::end_of_grabs() const {
  double end = 0;
  for (const ResolvedGrab& grab : grabs) end = std::max(end, grab.end());
  return end;
}

std::uint64_t mesh_hash(const TetMesh& mesh) {
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&](auto value) {  // least significant byte first on every machine
    for (std::size_t byte = 0; byte < sizeof value; ++byte) {
      hash = (hash ^ ((value >> (8 * byte)) & 0xff)) * 0x100000001b3;
    }
  };
  for (const Eigen::Vector3d& position : mesh.positions) {
    for (const double coordinate : position) add(std::bit_cast<std::uint64_t>(coordinate));
  }
  for (const Tet& tet : mesh.tets) {
    for (const std::uint32_t vertex : tet) add(vertex);
  }
  for (const MidEdges& mid_edges : mesh.mid_edges) {
    for (const std::uint32_t vertex : mid_edges) add(vertex);
  }
  return hash;
}

}  // namespace fascia
