// The order in which a solver stores tets and vertices.
#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

#include "sim/ordering/mesh_order.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;

namespace {

const TetMesh small = make_box(9, 5, 5, {0.9, 0.5, 0.5}), large = make_box(27, 15, 15, {0.9, 0.5, 0.5});

// A model with vertices in random order, one additional vertex without a tet, and a prescribed motion.
Model shuffled(TetMesh mesh) {
  mesh.positions.emplace_back(2, 2, 2);
  std::vector<std::uint32_t> to(mesh.positions.size());
  for (std::uint32_t v = 0; v < to.size(); ++v) to[v] = v;
  std::shuffle(to.begin(), to.end(), std::mt19937(3));
  const std::vector<Eigen::Vector3d> positions = mesh.positions;
  for (std::size_t v = 0; v < to.size(); ++v) mesh.positions[to[v]] = positions[v];
  for (Tet& tet : mesh.tets)
    for (std::uint32_t& v : tet) v = to[v];
  Model model = make_model(mesh, {1e4, 0.3, 1000, 0, MaterialModel::st_venant_kirchhoff},
                           [](const Eigen::Vector3d& x) { return x.x() < 1e-9; });
  Motion motion;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (model.rest_positions[v].x() > 0.85)
      motion.vertices.push_back(v), motion.targets.push_back(2 * model.rest_positions[v]);
  model.motions.push_back(motion);
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    model.initial_velocity[v] = 3 * model.rest_positions[v];
  return model;
}

}  // namespace

TEST_CASE("places and vertices correspond one to one") {
  const Model model = shuffled(small);
  const MeshOrder placement = mesh_order_of(model);
  REQUIRE(placement.vertex.size() == model.rest_positions.size());
  REQUIRE(placement.place.size() == model.rest_positions.size());
  for (std::uint32_t v = 0; v < placement.place.size(); ++v) CHECK(placement.vertex[placement.place[v]] == v);
  CHECK(model.rest_positions[placement.vertex.back()] == Eigen::Vector3d(2, 2, 2));
}

TEST_CASE("a placed model is the same body") {
  const Model model = shuffled(small);
  const MeshOrder placement = mesh_order_of(model);
  const Model moved = placed(model, placement);
  REQUIRE(moved.tets.size() == model.tets.size());
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    for (int a = 0; a < 4; ++a) CHECK(moved.rest_positions[moved.tets[t][a]] == model.rest_positions[model.tets[t][a]]);
  REQUIRE(moved.fixed.size() == model.fixed.size());
  CHECK(std::is_sorted(moved.fixed.begin(), moved.fixed.end()));
  for (const std::uint32_t v : moved.fixed) CHECK(moved.rest_positions[v].x() < 1e-9);
  REQUIRE(moved.motions.size() == 1);
  for (std::size_t k = 0; k < moved.motions[0].vertices.size(); ++k)
    CHECK(2 * moved.rest_positions[moved.motions[0].vertices[k]] == moved.motions[0].targets[k]);
  for (std::size_t v = 0; v < moved.rest_positions.size(); ++v)
    CHECK(moved.initial_velocity[v] == 3 * moved.rest_positions[v]);
  CHECK(moved.gravity == model.gravity);
  CHECK(moved.materials == model.materials);
}

TEST_CASE("the vertices of a tet are close together, for any order of the file") {
  const Model model = shuffled(large);
  const auto reach =
      [](const Model& m) {  // from the first to the last vertex of a tet, the median: a curve has some large distances
        std::vector<std::uint32_t> reaches;
        for (const Tet& tet : m.tets) {
          const auto [least, most] = std::minmax_element(tet.begin(), tet.end());
          reaches.push_back(*most - *least);
        }
        std::nth_element(reaches.begin(), reaches.begin() + static_cast<std::ptrdiff_t>(reaches.size() / 2),
                         reaches.end());
        return static_cast<double>(reaches[reaches.size() / 2]);
      };
  const double rows = reach(make_model(large, model.materials[0], [](const Eigen::Vector3d&) { return false; }));
  const double before = reach(model), after = reach(placed(model, mesh_order_of(model)));
  CAPTURE(rows, before, after);
  CHECK(rows < before);
  CHECK(after < rows);
}
