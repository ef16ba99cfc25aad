#include "sim/accuracy/refined_bodies.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "sim/elements/quadratic_tet.h"
#include "sim/grab/build_model.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/mesh/mid_edges.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

// A linear body with two materials that a motion bends, and a quadratic one that is held at one end.
Model two_bodies(const std::filesystem::path& targets) {
  nlohmann::json scene{{"fascia_scene", 1}};
  const nlohmann::json stiff{{"young_modulus", 2e5}, {"poisson_ratio", 0.3}, {"density", 1000}},
      soft{{"young_modulus", 1e4}, {"poisson_ratio", 0.3}, {"density", 1000}};
  scene["bodies"][0] = {
      {"name", "linear"},
      {"mesh", "a"},
      {"elements", "linear"},
      {"materials", {{"default", stiff}, {"1", soft}}},
      {"prescribed",
       {{{"select", {{"box", {{-1, -1, -1}, {0.01, 1, 1}}}}}, {"targets", targets.string()}, {"duration", 1}}}}};
  scene["bodies"][1] = {{"name", "quadratic"},
                        {"mesh", "b"},
                        {"elements", "quadratic"},
                        {"materials", {{"default", stiff}}},
                        {"transform", {{"translate", {0, 1, 0}}}},
                        {"initial_velocity", {0, 0, 2}},
                        {"fixed", {{{"box", {{-1, -1, -1}, {0.01, 1, 1}}}}}}};
  TetMesh a = make_box(2, 1, 1, {0.2, 0.1, 0.1});
  for (std::size_t t = 0; t < a.tets.size(); ++t) a.regions[t] = t < a.tets.size() / 2 ? 0 : 1;
  a.groups["end"] = {0, 1, 2, 3};
  return build_model(read_scene_content("two", scene.dump()), {a, make_box(2, 1, 1, {0.2, 0.1, 0.1})});
}

double volume_of(const Model& model, const std::string& material) {
  double sum = 0;
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    if (model.material_names[model.tet_material[t]] != material) continue;
    const auto& x = model.rest_positions;
    const Tet& v = model.tets[t];
    sum += signed_volume6(x[v[0]], x[v[1]], x[v[2]], x[v[3]]) / 6;
  }
  return sum;
}

}  // namespace

TEST_CASE("refined bodies keep their places, materials, supports, motions and velocities") {
  const TemporaryFolder folder;
  const auto targets = folder / "targets.csv";
  const TetMesh box = make_box(2, 1, 1, {0.2, 0.1, 0.1});
  std::string csv = "index,x,y,z\n";
  for (std::size_t v = 0; v < box.positions.size(); ++v) {
    const Vector3d& x = box.positions[v];
    if (x.x() == 0)
      csv += std::to_string(v) + ",0," + std::to_string(x.y() + 0.02) + ',' + std::to_string(x.z()) + '\n';
  }
  std::ofstream(targets) << csv;
  const Model coarse = two_bodies(targets);
  const RefinedBodies refined = refined_bodies(coarse);
  const Model& fine = refined.model;
  REQUIRE(fine.bodies.size() == 2);
  CHECK(fine.bodies[0].tet_count == coarse.bodies[0].tet_count);
  CHECK(fine.bodies[1].tet_count == 8 * coarse.bodies[1].tet_count);
  CHECK(fine.bodies[1].vertex_begin == fine.bodies[0].vertex_count);
  CHECK(fine.rest_positions.size() == fine.bodies[0].vertex_count + fine.bodies[1].vertex_count);
  for (std::size_t t = 0; t < fine.tets.size(); ++t) REQUIRE(fine.is_quadratic(t));
  for (std::size_t v = 0; v < coarse.rest_positions.size(); ++v)
    REQUIRE(fine.rest_positions[refined.places[v]] == coarse.rest_positions[v]);
  for (const MidEdge& edge : mid_edges_of(fine.file_mesh))
    REQUIRE(
        (fine.rest_positions[edge.vertex] - 0.5 * (fine.rest_positions[edge.a] + fine.rest_positions[edge.b])).norm() <
        1e-15);
  for (const std::string& name : coarse.material_names) {
    CAPTURE(name);
    CHECK(volume_of(fine, name) == Approx(volume_of(coarse, name)).epsilon(1e-12));
  }
  // An end of 0.1 x 0.1 m: nine vertices of quadratic faces, 25 once they are cut.
  CHECK(fine.fixed.size() == 25);
  for (const std::uint32_t v : fine.fixed) CHECK(fine.rest_positions[v].x() == 0);
  REQUIRE(fine.motions.size() == 1);
  const Motion& motion = fine.motions[0];
  REQUIRE(motion.vertices.size() == 9);
  REQUIRE(motion.targets.size() == 9);
  for (std::size_t k = 0; k < 9; ++k) {
    const Vector3d moved = motion.targets[k] - fine.rest_positions[motion.vertices[k]];
    CHECK((moved - Vector3d(0, 0.02, 0)).norm() < 1e-12);
  }
  for (std::uint32_t v = 0; v < fine.rest_positions.size(); ++v) {
    const bool thrown = v >= fine.bodies[1].vertex_begin;
    const double speed = thrown ? std::min(2.0, 20 * fine.rest_positions[v].x()) : 0;  // falls to the fixed end
    REQUIRE((fine.initial_velocity[v] - Vector3d(0, 0, speed)).norm() < 1e-14);
  }
  CHECK(fine.file_mesh.groups.at("end") == std::vector<std::uint32_t>{0, 1, 2, 3});
}

TEST_CASE("velocities of refined quadratic tets follow their quadratic functions") {
  nlohmann::json scene{{"fascia_scene", 1}};
  scene["bodies"][0] = {{"mesh", "box"}, {"elements", "quadratic"}};
  Model coarse = build_model(read_scene_content("one", scene.dump()), {make_box(2, 2, 1, {0.3, 0.2, 0.1})});
  const auto field = [](const Vector3d& x) {
    return Vector3d(x.y() * x.z() - x.x() * x.x(), 3 * x.x() * x.y(), x.z() * x.z() + x.x());
  };
  for (std::size_t v = 0; v < coarse.rest_positions.size(); ++v)
    coarse.initial_velocity[v] = field(coarse.rest_positions[v]);
  const Model fine = refined_bodies(coarse).model;
  for (std::size_t v = 0; v < fine.rest_positions.size(); ++v)
    REQUIRE((fine.initial_velocity[v] - field(fine.rest_positions[v])).norm() < 1e-14);
}
