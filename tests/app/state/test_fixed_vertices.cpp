// Vertices that are fixed and released in an open scene.
// Covers: deformed_positions
#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "app/state/continued_session.h"
#include "app/state/deformed_positions.h"
#include "app/state/fixed_vertices.h"
#include "base/file.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

struct Cube {
  Graphics graphics = open_graphics(headless(), false);
  Session session{graphics, open_scene(source_dir() / "assets/scenes/cube.json"), false};
  const Model& model() const { return session.simulation.model; }
  const Scene& scene() const { return session.simulation.scene; }
  std::uint32_t free_vertex() const {
    const std::vector<char> held = model().held();
    return static_cast<std::uint32_t>(std::find(held.begin(), held.end(), 0) - held.begin());
  }
};

}  // namespace

TEST_CASE("a fixed vertex joins those of the scene, and the last one that is released leaves no selection") {
  Cube cube;
  const std::uint32_t v = cube.free_vertex();
  CHECK(with_fixed(cube.scene(), cube.model(), {}, true) == fixed_of(cube.scene()));
  CHECK(with_fixed(cube.scene(), cube.model(), cube.model().fixed, true) == fixed_of(cube.scene()));

  const FixedSets more = with_fixed(cube.scene(), cube.model(), std::vector{v}, true);
  REQUIRE(more.size() == 1);
  REQUIRE(more[0].size() == 1);
  std::vector<std::uint32_t> expected = cube.model().fixed;
  expected.push_back(v);
  std::sort(expected.begin(), expected.end());
  CHECK(std::get<VertexSelection>(more[0][0]).vertices == expected);

  CHECK(with_fixed(cube.scene(), cube.model(), cube.model().fixed, false) == FixedSets{{}});
}

TEST_CASE("in a body of quadratic tets, middles of edges follow their ends and are not listed") {
  Cube cube;
  Scene scene = cube.scene();
  scene.bodies[0].elements = ElementOrder::quadratic;
  const Model model = build_model(scene);
  std::vector<std::uint32_t> all(model.rest_positions.size());
  std::iota(all.begin(), all.end(), 0u);
  const FixedSets sets = with_fixed(scene, model, all, true);
  REQUIRE(sets[0].size() == 1);
  CHECK(std::get<VertexSelection>(sets[0][0]).vertices.size() == cube.model().rest_positions.size());
  scene.bodies[0].fixed = sets[0];
  CHECK(build_model(scene).fixed.size() == all.size());
}

TEST_CASE("a vertex with a prescribed motion is neither fixed nor released") {
  Cube cube;
  Model model = cube.model();
  const std::uint32_t v = cube.free_vertex();
  model.motions.push_back(Motion{});
  model.motions.back().vertices = {v};
  CHECK(with_fixed(cube.scene(), model, std::vector{v}, true) == fixed_of(cube.scene()));
}

TEST_CASE("the vertices of each body are counted from its own first one, and other bodies keep their selections") {
  Scene scene = open_scene(source_dir() / "assets/scenes/cube.json");
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].transform.translate.x() = 1;
  const Model model = build_model(scene);
  const std::uint32_t begin = model.bodies[1].vertex_begin;
  REQUIRE(begin > 0);
  std::vector<std::uint32_t> of_second;
  for (const std::uint32_t v : model.fixed)
    if (v >= begin) of_second.push_back(v);
  REQUIRE(of_second.size() > 1);
  const FixedSets sets = with_fixed(scene, model, std::vector{of_second.front()}, false);
  CHECK(sets[0] == scene.bodies[0].fixed);
  std::vector<std::uint32_t> expected;
  for (std::size_t i = 1; i < of_second.size(); ++i) expected.push_back(of_second[i] - begin);
  CHECK(std::get<VertexSelection>(sets[1].at(0)).vertices == expected);
}

TEST_CASE("a session with other fixed vertices continues from the state and reads back from its scene") {
  Cube cube;
  for (int i = 0; i < 10; ++i) cube.session.simulation.step();
  cube.session.camera.orbit(0.3, 0.1);
  const State before = cube.session.simulation.state();
  const std::uint32_t v = cube.free_vertex();
  REQUIRE(before.displacement[v].norm() > 0);
  Scene scene = cube.scene();
  scene.bodies[0].fixed = with_fixed(scene, cube.model(), std::vector{v}, true)[0];
  const auto session = continued_session(cube.graphics, cube.session, scene);
  const Model& model = session->simulation.model;
  CHECK(std::count(model.fixed.begin(), model.fixed.end(), v) == 1);
  CHECK(model.fixed.size() == cube.model().fixed.size() + 1);
  CHECK(session->camera.eye == cube.session.camera.eye);
  const State after = session->simulation.state();
  CHECK(after.time == before.time);
  CHECK(after.displacement[v].norm() == 0);
  for (std::size_t i = 0; i < before.displacement.size(); ++i) {
    if (i == v) continue;
    CAPTURE(i);
    REQUIRE((after.displacement[i] - before.displacement[i]).norm() < 1e-6);
  }
  for (int i = 0; i < 5; ++i) session->simulation.step();
  const std::vector<Eigen::Vector3d> shown = deformed_positions(*session);
  CHECK((shown[v] - model.rest_positions[v]).norm() < 1e-7);  // it stays
  const TemporaryFolder folder;
  write_file(folder / "saved.json", scene_to_json(session->simulation.scene, folder.path()));
  const Scene read = open_scene(folder / "saved.json");
  CHECK(read.bodies[0].fixed == scene.bodies[0].fixed);
  CHECK(build_model(read).fixed == model.fixed);
}
