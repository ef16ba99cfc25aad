// Cases with meshes of few tets, of bad tets, of several parts, and of sizes from a millimeter to a hundred meters.
#include <cmath>
#include <numbers>
#include <random>

#include "app/stress/case_maker.h"
#include "sim/grab/build_model.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/model/model.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

// Displaces every vertex by up to a tenth of its mean distance to the others of its elements.
std::optional<State> shaken(const Scene& scene) {
  const Model built = build_model(scene);
  std::vector<double> edge(built.rest_positions.size(), 0), count(edge);
  for (std::size_t t = 0; t < built.tets.size(); ++t)
    for (const std::uint32_t a : built.element(t))
      for (const std::uint32_t b : built.element(t)) {
        edge[a] += (built.rest_positions[a] - built.rest_positions[b]).norm();
        count[a] += a != b;
      }
  std::mt19937 random(8);
  std::uniform_real_distribution<double> uniform(-0.1, 0.1);
  std::size_t v = 0;
  State state = initial_state(built);
  const std::vector<char> held = built.held();
  for (; v < edge.size(); ++v)
    if (!held[v] && count[v] > 0)
      state.displacement[v] =
          float32_of(edge[v] / count[v] * Vector3d(uniform(random), uniform(random), uniform(random)));
  return state;
}

StressCase& shape(StressCases& c, const std::string& name, const TetMesh& mesh, bool clamped, double scale = 1) {
  Scene s = c.scene(name, mesh, clamped);
  s.bodies[0].transform.scale = scale;
  std::optional<State> state = shaken(s);
  StressCase& made = c.add("mesh", name, std::move(s), std::move(state), 180);
  made.criteria.creates_no_energy = true;
  made.criteria.creates_no_momentum = !clamped;
  return made;
}

}  // namespace

void add_meshes(StressCases& c) {
  const auto simplex = [](double x, const Vector3d& apex) {
    TetMesh mesh;
    mesh.positions = {{0, 0, 0}, {x, 0, 0}, {0.5 * x, 0.8 * x, 0}, apex};
    mesh.tets = {{0, 1, 2, 3}};
    mesh.regions = {0};
    return mesh;
  };
  shape(c, "single tet", simplex(0.1, {0.05, 0.03, 0.08}), false);
  TetMesh pair_of_tets = simplex(0.1, {0.05, 0.03, 0.08});
  pair_of_tets.positions.insert(pair_of_tets.positions.end(), {{0.05, -0.06, -0.02}, {0.05, -0.05, -0.09}});
  pair_of_tets.tets.push_back({0, 1, 5, 4});
  pair_of_tets.regions.push_back(0);
  shape(c, "two tets sharing an edge", pair_of_tets, false);
  shape(c, "needle", simplex(0.001, {0.0005, 0.0003, 0.1}), false);
  shape(c, "cap", simplex(0.1, {0.05, 0.03, 0.0002}), false);

  // Every second layer of cells is flattened until its tets have dihedral angles of 0.1 degrees.
  TetMesh slivers = c.beam();
  const int along = c.quick ? 4 : 8;
  const double cell = kBarLength / along,
               thin = (kBarWidth / (c.quick ? 2 : 4)) * std::tan(0.1 * std::numbers::pi / 180);
  deform(slivers, [&](const Vector3d& x) -> Vector3d {
    const int layer = static_cast<int>(std::lround(x.x() / cell));
    const int pairs = layer / 2;
    return {pairs * (cell + thin) + (layer % 2) * cell, x.y(), x.z()};
  });
  // Perturbed by a tenth of the long edges, the thin layers are inverted by fifty times their thickness.
  StressCase& squashed = shape(c, "slivers", slivers, true);
  squashed.criteria.recovers = true;
  squashed.criteria.farthest = 10;

  TetMesh parts = c.beam();
  const TetMesh one = parts;
  for (const double offset : {0.3, 0.6}) {
    const auto base = static_cast<std::uint32_t>(parts.positions.size());
    for (const Vector3d& x : one.positions) parts.positions.push_back(x + Vector3d(0, offset, 0));
    for (const Tet& tet : one.tets) parts.tets.push_back({tet[0] + base, tet[1] + base, tet[2] + base, tet[3] + base});
    parts.regions.resize(parts.tets.size(), 0);
  }
  shape(c, "disconnected parts", parts, true).criteria.recovers = true;
  shape(c, "1 mm", c.beam(), true, 1e-3 / kBarLength).criteria.recovers = true;
  // The ratio of stiffness to weight is that of the small ones, so that it comes to rest in time.
  StressCase& large = shape(c, "100 m", c.beam(), true, 100 / kBarLength);
  large.replay.scene.bodies[0].material.young_modulus = 1e10;
  large.criteria.recovers = true;
}

}  // namespace fascia
