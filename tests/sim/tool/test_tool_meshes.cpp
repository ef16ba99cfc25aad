// Meshes of tools in a scene: read, shared, kept as paths, refused in one line.
#include "sim/tool/tool_meshes.h"

#include <catch2/catch.hpp>

#include "base/file.h"
#include "sim/grab/build_model.h"
#include "sim/scene/scene_carry.h"
#include "sim/scene/scene_write.h"
#include "sim/tool/shape_distance.h"
#include "tests/support/support.h"
#include "tests/support/surfaces.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

void write_obj(const std::filesystem::path& path, const SurfaceMesh& surface) {
  std::string text;
  for (const Vector3d& x : surface.positions)
    text += "v " + std::to_string(x.x()) + " " + std::to_string(x.y()) + " " + std::to_string(x.z()) + "\n";
  for (const Triangle& t : surface.triangles)
    text += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " + std::to_string(t[2] + 1) + "\n";
  write_file(path, text);
}

}  // namespace

TEST_CASE("a scene's tools may be meshes", "[contact]") {
  const test::TemporaryFolder folder;
  write_obj(folder / "spoon.obj", test::make_box_surface({10, 2, 4}));
  const auto open = [&](const std::string& file) {
    write_file(folder / "s.json", R"({"fascia_scene": 1, "bodies": [{"mesh": ")" +
                                      (test::source_dir() / "assets/meshes/cube.msh").string() + R"("}],
      "obstacles": [{"name": "rest", "shape": {"mesh": {"file": ")" +
                                      file + R"(", "scale": 0.01}}}],
      "instruments": [{"name": "spoon", "shape": {"mesh": {"file": ")" +
                                      file + R"(", "scale": 0.01}}},
                      {"name": "forceps", "jaws": {"shape": {"mesh": {"file": "spoon.obj", "scale": 0.001}}}}]})");
    return open_scene(folder / "s.json");
  };
  const Scene scene = open("spoon.obj");
  Model model = build_model(scene);
  REQUIRE(model.tools.size() == 3);
  const auto solid = [&](std::size_t t) { return std::get<MeshShape>(model.tools[t].shape).solid; };
  CHECK(solid(0) == solid(1));  // measured once
  CHECK(solid(0) != solid(2));
  CHECK(distance_to(model.tools[1].shape, {0.05, 0.015, 0.02}).distance == Approx(-0.005).epsilon(0.01));
  CHECK(model.tools[2].has_jaws);
  REQUIRE(model.files.size() == 4);
  CHECK(model.files[3].key == "bodies[0].mesh");
  CHECK(model.files[0].key == "obstacles[0].shape.mesh.file");

  Scene in_millimeters = scene;
  std::get<MeshShape>(in_millimeters.tools.obstacles[0].shape).scale = 1;
  CHECK_THAT(build_model(in_millimeters).notes.front(), Catch::StartsWith("rest: 10 m wide, "));

  const std::string text = scene_to_json(self_contained(scene, model.files), {});
  std::filesystem::remove(folder / "spoon.obj");
  write_file(folder / "moved.json", text);
  CHECK(build_model(open_scene(folder / "moved.json")).tools.size() == 3);

  CHECK_THROWS_WITH(build_model(open("none.obj")),
                    Catch::Contains("obstacles[0].shape.mesh.file: none.obj: no such file"));
  SurfaceMesh hole = test::make_sphere(12, 24, 5);
  hole.triangles.pop_back();
  write_obj(folder / "hole.obj", hole);
  CHECK_THROWS_WITH(build_model(open("hole.obj")), Catch::Contains("hole.obj: is open: 3 edges of one triangle only"));
}
