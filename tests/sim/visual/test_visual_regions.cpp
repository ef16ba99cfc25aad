// Regions in pictures: a number for every tet and every drawn triangle.
#include "sim/visual/visual_regions.h"

#include <catch2/catch.hpp>

#include "tests/support/models.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

/// A row of 4 cells of 6 tets: 12 tets of region 5, named "fat", then 12 of region -2.
Model row() {
  Model model = test::make_model(make_box(4, 1, 1, {4, 1, 1}), Material{}, [](const Vector3d&) { return false; });
  model.surfaces.resize(1);
  model.file_mesh.regions.clear();
  for (const Tet& tet : model.tets) {
    double x = 0;
    for (const std::uint32_t v : tet) x += model.rest_positions[v].x() / 4;
    model.file_mesh.regions.push_back(x < 2 ? 5 : -2);
  }
  model.bodies[0].name = "liver";
  model.bodies[0].regions = {{-2, ""}, {5, "fat"}};
  return model;
}

Scene scene_of(std::size_t bodies) {
  Scene scene;
  scene.bodies.resize(bodies);
  return scene;
}

}  // namespace

TEST_CASE("regions are named and numbered by their numbers, and a triangle has that of its tet") {
  const Model model = row();
  const VisualSurface surface = drawn_surface(model);
  const VisualRegions regions = drawn_regions(scene_of(1), model, surface);
  CHECK(regions.names == std::vector<std::string>{"region -2", "fat"});
  REQUIRE(regions.of_tet.size() == 24);
  for (std::size_t t = 0; t < 24; ++t) CHECK(regions.of_tet[t] == (model.file_mesh.regions[t] == 5 ? 1u : 0u));
  REQUIRE(regions.of_triangle.size() == surface.triangles.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    double x = 0;
    for (const std::uint32_t v : surface.triangles[i]) x += surface.rest_positions[v].x() / 3;
    CAPTURE(i, x);
    CHECK(regions.of_triangle[i] == (x < 2 ? 1u : 0u));
  }
}

TEST_CASE("tets that are left out of the file do not move the others' regions") {
  Model model = row();
  model.file_mesh.regions.insert(model.file_mesh.regions.begin(), 77);
  for (std::uint32_t& source : model.tet_source) ++source;
  const VisualRegions regions = drawn_regions(scene_of(1), model, drawn_surface(model));
  CHECK(regions.names == std::vector<std::string>{"region -2", "fat"});
}

TEST_CASE("each of several bodies has its own regions, with its name") {
  Model model = row();
  model.bodies.push_back(model.bodies[0]);
  model.surfaces.resize(2);
  model.bodies[0].tet_count = 18;
  model.bodies[1].tet_begin = 18;
  model.bodies[1].tet_count = 6;
  model.bodies[1].name = "skin";
  const VisualRegions regions = drawn_regions(scene_of(2), model, drawn_surface(model));
  CHECK(regions.names == std::vector<std::string>{"liver: region -2", "liver: fat", "skin: region -2"});
  CHECK(regions.of_tet.front() == 1);
  CHECK(regions.of_tet[17] == 0);
  CHECK(regions.of_tet.back() == 2);
}

TEST_CASE("a triangle of a surface has the region of the tet in which its first vertex is embedded") {
  Model model = row();
  SurfaceMesh& surface = model.surfaces[0];
  surface.positions = {{0.3, 0.4, 0.5}, {3.7, 0.4, 0.5}, {3.6, 0.6, 0.3}};
  surface.triangles = {{0, 1, 2}, {1, 2, 0}};
  model.embedded = embed(surface.positions, model.rest_positions, model.tets);
  const VisualRegions regions = drawn_regions(scene_of(1), model, drawn_surface(model));
  CHECK(regions.of_triangle == std::vector<std::uint32_t>{1, 0});
}
