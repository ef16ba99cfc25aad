#include "sim/gpu/self_test/trial_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "sim/mesh/mesh_generate.h"
#include "sim/mesh/mid_edges.h"

namespace fascia {

Material trial_tissue(MaterialModel law, double damping) { return {2e4, 0.35, 1050, damping, law}; }

Model trial_box(const Material& material, bool quadratic) {
  Model model;
  TetMesh& mesh = model.file_mesh;
  mesh = quadratic ? make_box(3, 3, 3, {0.1, 0.1, 0.1}) : make_box(5, 4, 4, {0.1, 0.1, 0.1});
  std::vector<std::uint32_t> all(mesh.tets.size());
  std::iota(all.begin(), all.end(), 0u);
  if (quadratic) add_mid_edges(mesh, all);
  model.rest_positions = mesh.positions;
  model.tets = mesh.tets;
  model.mid_edges = mesh.mid_edges;
  model.tet_source = all;
  model.tet_material.assign(all.size(), 0);
  model.materials = {material};
  model.material_names = {"trial"};
  model.initial_velocity.assign(mesh.positions.size(), Eigen::Vector3d::Zero());
  const auto vertices = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t v = 0; v < vertices; ++v)
    if (mesh.positions[v].x() == 0) model.fixed.push_back(v);
  model.bodies = {{"trial", 0, vertices, 0, static_cast<std::uint32_t>(all.size()), 0, 1, {}}};
  return model;
}

State trial_state(const Model& model, double amplitude) {
  std::mt19937 random(7);
  const auto next = [&] { return amplitude * (static_cast<double>(random() % 2001) / 1000 - 1); };
  State state = initial_state(model);
  const std::vector<char> held = model.held();
  for (std::size_t v = 0; v < held.size(); ++v)
    for (int k = 0; k < 3; ++k) {
      const double u = next(), speed = 10 * next();
      if (held[v]) continue;
      // Rounded to float32, so that both sides start from the same numbers
      state.displacement[v][k] = static_cast<double>(static_cast<float>(u));
      state.velocity[v][k] = static_cast<double>(static_cast<float>(speed));
    }
  return state;
}

double relative_deviation(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b) {
  double error = 0, size = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    error += (a[v] - b[v]).squaredNorm();
    size += b[v].squaredNorm();
  }
  return std::isfinite(error) ? std::sqrt(error / size) : std::numeric_limits<double>::infinity();
}

}  // namespace fascia
