// The drawn surface of a model: the boundary of its tets, or the bodies' own surfaces.
#include "sim/visual/visual_surface.h"

#include <catch2/catch.hpp>

#include "sim/mesh/tet_faces.h"
#include "tests/support/models.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

/// Two bodies of one tet each, without their own surfaces.
Model two_tets() {
  Model model;
  model.rest_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}};
  model.tets = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  model.bodies = {{"a", 0, 4, 0, 1, 0, 1, {}}, {"b", 4, 4, 1, 1, 0, 1, {}}};
  model.surfaces.resize(2);
  return model;
}

SurfaceMesh triangle(double x) {
  SurfaceMesh surface;
  surface.positions = {{x, 0, 0}, {x, 1, 0}, {x, 0, 1}};
  surface.triangles = {{0, 1, 2}};
  return surface;
}

}  // namespace

TEST_CASE("without surfaces the boundaries of all bodies are drawn, one after the other") {
  const Model model = two_tets();
  const VisualSurface drawn = drawn_surface(model);
  CHECK(drawn.rest_positions == model.rest_positions);
  CHECK(drawn.triangles == boundary_triangles(model.tets));
  CHECK(drawn.triangles.size() == 8);
  CHECK(drawn.colors.empty());
  CHECK_FALSE(closed_around_tets(model));
}

TEST_CASE("surfaces stand behind the mesh's vertices, in the order of the bodies") {
  Model model = two_tets();
  model.surfaces = {triangle(1), triangle(2)};
  const VisualSurface drawn = drawn_surface(model);
  REQUIRE(drawn.rest_positions.size() == 14);
  CHECK(drawn.triangles == std::vector<Triangle>{{8, 9, 10}, {11, 12, 13}});
  CHECK(drawn.rest_positions[8] == Vector3d(1, 0, 0));
  CHECK(drawn.rest_positions[13] == Vector3d(2, 0, 1));
}

TEST_CASE("colors of one body leave the others without, triangle by triangle") {
  Model model = two_tets();
  model.surfaces[1] = triangle(2);
  model.surfaces[1].colors = {1, 2, 3};
  const VisualSurface drawn = drawn_surface(model);
  REQUIRE(drawn.triangles.size() == 5);
  CHECK(drawn.triangles[4] == Triangle{8, 9, 10});
  CHECK(drawn.colors == std::vector<std::uint32_t>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3});
  std::swap(model.surfaces[0], model.surfaces[1]);
  CHECK(drawn_surface(model).colors == std::vector<std::uint32_t>{1, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
}

TEST_CASE("a model is closed around its tets if it has surfaces and all of them are closed") {
  Model model = two_tets();
  model.surfaces[0] = triangle(1);
  CHECK_FALSE(closed_around_tets(model));
  model.surfaces[0].closed = true;
  CHECK(closed_around_tets(model));
  model.surfaces[1] = triangle(2);
  CHECK_FALSE(closed_around_tets(model));
}

TEST_CASE("marks lie on the drawn surface, and only where it is near the marked vertex") {
  Model model = two_tets();
  CHECK(drawn_marks(model, {0, 2, 5}) == std::vector<std::uint32_t>{0, 2, 5});
  // Body b has a surface of three vertices: two near vertex 5, the nearer one last, and one in the middle of its tet.
  model.surfaces[1] = triangle(5);
  model.embedded.points = model.surfaces[1].positions;
  model.embedded.ties = {
      {{4, 5, 6, 7}, {0.3, 0.5, 0.1, 0.1}}, {{4, 5, 6, 7}, {0.25, 0.25, 0.25, 0.25}}, {{4, 5, 6, 7}, {0.1, 0.9, 0, 0}}};
  CHECK(drawn_marks(model, {0, 2}) == std::vector<std::uint32_t>{0, 2});
  CHECK(drawn_marks(model, {2, 4, 5, 6}) == std::vector<std::uint32_t>{2, 10});
  INFO("a vertex in the middle of an edge is near where its shape function is large");
  for (int k = 0; k < 6; ++k) model.rest_positions.emplace_back(9, 9, k);
  model.bodies[1].vertex_count += 6;
  const MidEdges middles{8, 9, 10, 11, 12, 13};
  model.embedded.quadratic = {{middles, {0, 0, 0, 0, 0.3, 0.6, 0, 0, 0, 0.1}},
                              {middles, {0, 0, 0, 0, 0.2, 0.2, 0.2, 0.2, 0.1, 0.1}},
                              {kNoMidEdges, {0.1, 0.9, 0, 0}}};
  CHECK(drawn_marks(model, {8}).empty());
  CHECK(drawn_marks(model, {9}) == std::vector<std::uint32_t>{14});
}
