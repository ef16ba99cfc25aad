// Models built in code, for tests of solvers.
#pragma once
#include <algorithm>
#include <functional>
#include <random>
#include <utility>

#include "sim/elements/quadratic_tet.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/mesh/mid_edges.h"
#include "sim/model/model.h"
#include "sim/reference/newton.h"

namespace fascia::test {

/// A model of a valid mesh with one material, fixed where `fixed` is true.
inline Model make_model(const TetMesh& mesh, const Material& material,
                        const std::function<bool(const Eigen::Vector3d&)>& fixed) {
  Model model;
  model.rest_positions = mesh.positions;
  model.tets = mesh.tets;
  model.tet_material.assign(mesh.tets.size(), 0);
  model.materials = {material};
  model.material_names = {"body: default"};
  model.initial_velocity.assign(mesh.positions.size(), Eigen::Vector3d::Zero());
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i)
    if (fixed(mesh.positions[i])) model.fixed.push_back(i);
  model.file_mesh = mesh;
  for (std::uint32_t t = 0; t < mesh.tets.size(); ++t) model.tet_source.push_back(t);
  const auto vertices = static_cast<std::uint32_t>(mesh.positions.size());
  const auto tets = static_cast<std::uint32_t>(mesh.tets.size());
  model.bodies = {{"body", 0, vertices, 0, tets, 0, 1, {}}};
  return model;
}

/// Makes the tets of a box model from `first` on quadratic; a mid-edge vertex is fixed if both ends of its edge are.
inline Model quadratic(Model model, std::uint32_t first = 0) {
  add_mid_edges(model.file_mesh, {model.tet_source.begin() + first, model.tet_source.end()});
  model.rest_positions = model.file_mesh.positions;
  model.mid_edges = model.file_mesh.mid_edges;
  const std::vector<char> held = model.held();
  for (const MidEdge& edge : mid_edges_of(model.file_mesh))
    if (held[edge.a] && held[edge.b]) model.fixed.push_back(edge.vertex);
  std::sort(model.fixed.begin(), model.fixed.end());
  model.initial_velocity.resize(model.rest_positions.size(), Eigen::Vector3d::Zero());
  return model;
}

/// Displacements and velocities of about `amplitude` [m], different at every vertex, zero where constrained; the same
/// for the same seed.
inline State random_state(const Model& model, double amplitude, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-amplitude, amplitude);
  State state = initial_state(model);
  const std::vector<char> held = model.held();
  for (std::size_t i = 0; i < state.displacement.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const double u = uniform(random), v = uniform(random);
      if (held[i]) continue;
      // Rounded to float32, so that both sides of a comparison start from the same numbers.
      state.displacement[i][k] = static_cast<float>(u);
      state.velocity[i][k] = static_cast<float>(10 * v);
    }
  return state;
}

/// RMS of a - b over the RMS of b.
inline double relative_rms(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b) {
  double error = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    error += (a[i] - b[i]).squaredNorm();
    size += b[i].squaredNorm();
  }
  return std::sqrt(error / size);
}

/// The largest distance of a vertex between two states [m].
inline double farthest(const State& a, const State& b) {
  double distance = 0;
  for (std::size_t v = 0; v < a.displacement.size(); ++v)
    distance = std::max(distance, (a.displacement[v] - b.displacement[v]).norm());
  return distance;
}

/// The number of vertices whose displacement or velocity differs, be it by one bit.
inline std::size_t differences(const State& a, const State& b) {
  std::size_t count = 0;
  for (std::size_t v = 0; v < a.displacement.size(); ++v)
    count += a.displacement[v] != b.displacement[v] || a.velocity[v] != b.velocity[v];
  return count;
}

/// Whether a place is on the side x = 0, by which most boxes are held.
inline bool at_left_end(const Eigen::Vector3d& x) { return x.x() < 1e-9; }

/// The default settings, at sixty steps a second.
inline SolverSettings frames() {
  SolverSettings settings;
  settings.time_step = 1.0 / 60;
  return settings;
}

/// Momentum of what free vertices move [kg m/s]: their own masses, and those at the centroids of tets with a free
/// vertex.
inline Eigen::Vector3d free_momentum(const Model& model, const std::vector<Eigen::Vector3d>& velocity) {
  const MovingMasses masses = moving_masses(model);
  const std::vector<char> held = model.held();
  Eigen::Vector3d momentum(0, 0, 0);
  for (std::size_t v = 0; v < velocity.size(); ++v)
    if (!held[v]) momentum += masses.own[v] * velocity[v];
  for (std::size_t t = 0; t < masses.centroid.size(); ++t) {
    const auto is_held = [&](std::uint32_t v) { return held[v] != 0; };
    const ElementVertices element = model.element(t);
    if (!model.is_quadratic(t) || std::all_of(element.begin(), element.end(), is_held)) continue;
    for (std::size_t n = 0; n < element.size(); ++n)
      momentum += masses.centroid[t] * QuadraticTet::at_centroid(n) * velocity[element[n]];
  }
  return momentum;
}

/// The weight of the whole body, of what is held, too [N].
inline Eigen::Vector3d weight_of(const Model& model) {
  double mass = 0;
  for (const double m : lumped_masses(model)) mass += m;
  return mass * model.gravity;
}

/// Gives the vertices that are fixed a motion of duration 0.08 s instead.
inline void shake_fixed(Model& model) {
  Motion shake;
  shake.vertices = std::exchange(model.fixed, {});
  shake.translate = {0.02, 0.05, 0};
  shake.angle = 0.5;
  shake.duration = 0.08;
  model.motions = {shake};
}

/// The largest displacement of a vertex [m].
inline double largest_displacement(const State& state) {
  double largest = 0;
  for (const Eigen::Vector3d& u : state.displacement) largest = std::max(largest, u.norm());
  return largest;
}

}  // namespace fascia::test
