// Scenes whose mesh is a surface: opened on its own, resolution by key and by --set, written and read again.
#include <catch2/catch.hpp>

#include "base/error.h"
#include "base/file.h"
#include "sim/bare_mesh/settled_model.h"
#include "sim/grab/build_model.h"
#include "sim/model/model.h"
#include "sim/scene/scene.h"
#include "tests/support/support.h"

using namespace fascia;

namespace {

const std::filesystem::path kidney = test::source_dir() / "assets/meshes/kidney.obj";

}  // namespace

TEST_CASE("a surface on its own opens, filled and drawn with its colors") {
  Scene scene = open_scene(kidney, {"resolution=12"});
  REQUIRE(scene.bodies.size() == 1);
  CHECK(scene.bodies[0].resolution == 12);
  const Model model = settled_model(scene);
  CHECK(!model.fixed.empty());
  REQUIRE(model.surfaces.size() == 1);
  CHECK(model.surfaces[0].colors.size() == 3 * model.surfaces[0].triangles.size());
  CHECK(model.embedded.points.size() == model.surfaces[0].positions.size());
  CHECK(build_model(open_scene(kidney, {"bodies.0.resolution=16"})).tets.size() > model.tets.size());
}

TEST_CASE("the resolution is checked, and written so that it reads back") {
  const Scene scene = open_scene(kidney, {"resolution=31"});
  const Scene again = read_scene_content(kidney, scene_to_json(scene, kidney.parent_path()));
  CHECK(again.bodies == scene.bodies);
  CHECK_THROWS_WITH(open_scene(kidney, {"resolution=1"}), Catch::Contains("resolution") && Catch::Contains("2 to 256"));
  CHECK_THROWS_WITH(build_model(open_scene(test::source_dir() / "assets/meshes/cube.msh", {"resolution=20"})),
                    Catch::Contains("bodies[0].resolution: is given for a mesh of tets"));
  CHECK(!open_scene(kidney).bodies[0].resolution);
}

TEST_CASE("a surface over a mesh is drawn outward, each triangle once, for any winding in its file") {
  const test::TemporaryFolder folder;
  write_file(
      folder / "skin.obj",
      "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\nf 4 3 2\n");  // inward, one twice
  Scene scene = open_scene(test::source_dir() / "assets/meshes/cube.msh");
  scene.bodies[0].surface = (folder / "skin.obj").string();
  const SurfaceMesh skin = build_model(scene).surfaces.at(0);
  CHECK(skin.triangles == std::vector<Triangle>{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  CHECK(skin.closed);
}
