// Meshes on their own from file to result: they stay upright for ten seconds, and say how they were opened.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/mesh/mid_edges.h"
#include "tests/support/bare_shapes.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

nlohmann::json stats_after(const TetMesh& mesh, int steps) {
  const TemporaryFolder folder;
  write_mesh(folder / "mesh.msh", mesh);
  const CommandResult result =
      run_fascia({"run", "mesh.msh", "--steps", std::to_string(steps), "--stats", "stats.json"}, folder.path());
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK_THAT(result.err, Catch::Contains("mesh: taken as ") && !Catch::Contains("inside out"));
  return nlohmann::json::parse(read_file(folder / "stats.json"));
}

}  // namespace

TEST_CASE("meshes on their own have no inverted tet after 600 steps") {
  TetMesh tip_down = make_cone(50, 100, 0.05, 4, 8);
  for (Eigen::Vector3d& p : tip_down.positions) p.y() = -p.y();
  TetMesh needle = make_box(1, 24, 1, {1, 100, 1});
  const std::pair<const char*, TetMesh> meshes[] = {
      {"ball in mm", make_ball(60, 6)},
      {"cone on its side", turned(make_cone(0.05, 0.2, 0.02, 4, 8), 2)},
      {"cone on its tip", tip_down},
      {"tower", make_box(2, 10, 2, {0.1, 0.6, 0.1})},
      {"needle in mm", needle},
      {"plate", make_box(8, 1, 8, {0.3, 0.006, 0.3})},
      {"two pieces", together(make_box(3, 3, 3, {0.1, 0.1, 0.1}), make_ball(0.05, 4), {0.05, 0.3, 0.05})},
      {"cell of 20 um", make_ball(1e-5, 6)},
  };
  for (const auto& [name, mesh] : meshes) {
    CAPTURE(name);
    const nlohmann::json stats = stats_after(mesh, 600);
    CHECK(stats["inverted"] == 0);
    CHECK(stats["volume_ratio"].get<double>() == Approx(1).epsilon(0.1));
  }
}

TEST_CASE("info prints the plan of a mesh on its own, and none for a scene") {
  const TemporaryFolder folder;
  write_mesh(folder / "cone.msh", turned(make_cone(50, 100), 2));
  const CommandResult bare = run_fascia({"info", "cone.msh"}, folder.path());
  REQUIRE(bare.exit_code == 0);
  CHECK_THAT(bare.out, Catch::Contains("\n  unit         mm: 100 mm wide; another one: --unit\n") &&
                           Catch::Contains("\n  up           z: stands on its flat side; another axis: --up\n") &&
                           Catch::Contains("\n  supports     held at the lowest 2 %") &&
                           Catch::Contains("\n  stiffness    ") && Catch::Contains(" mm, from (") &&
                           Catch::Contains(" mm^3\n") && !Catch::Contains("too large for tissue"));
  const CommandResult given = run_fascia({"info", "cone.msh", "--unit", "cm", "--up=-x"}, folder.path());
  CHECK_THAT(given.out,
             Catch::Contains("unit         cm: 100 cm wide, as given") && Catch::Contains("up           -x: as given"));
  write_file(folder / "scene.json",
             R"({"fascia_scene": 1, "bodies": [{"mesh": "cone.msh", "fixed": [{"lowest": 0.02}]}]})");
  const CommandResult scene = run_fascia({"info", "scene.json"}, folder.path());
  CHECK_THAT(scene.out, !Catch::Contains("opened on its own") && Catch::Contains("too large for tissue"));
}

TEST_CASE("info reports the mid-edge vertices of a file as the scene uses them") {
  const TemporaryFolder folder;
  TetMesh mesh = make_box(1, 1, 1, {0.1, 0.1, 0.1});
  const std::size_t corners = mesh.positions.size();
  add_mid_edges(mesh, {0, 1, 2, 3, 4, 5});
  const std::string unused = std::to_string(mesh.positions.size() - corners) + " of them in no usable tet";
  write_mesh(folder / "ten.msh", mesh);
  for (const bool quadratic : {false, true}) {
    write_file(folder / "scene.json",
               std::string(R"({"fascia_scene": 1, "bodies": [{"mesh": "ten.msh", "elements": ")") +
                   (quadratic ? "quadratic" : "linear") + "\"}]}");
    const CommandResult result = run_fascia({"info", "scene.json"}, folder.path());
    CAPTURE(quadratic, result.out);
    REQUIRE(result.exit_code == 0);
    CHECK((result.out.find(unused) != std::string::npos) == !quadratic);
    CHECK((result.out.find("kept the corners") != std::string::npos) == !quadratic);
  }
}

TEST_CASE("an unknown unit or axis is wrong usage") {
  const std::string cube = (source_dir() / "assets/meshes/cube.msh").string();
  const CommandResult unit = run_fascia({"run", cube, "--unit", "ft"});
  CHECK(unit.exit_code == 2);
  CHECK_THAT(unit.err, Catch::Contains("--unit") && Catch::Contains("m, cm, mm, um, in"));
  const CommandResult up = run_fascia({"run", cube, "--up", "up"});
  CHECK(up.exit_code == 2);
  CHECK_THAT(up.err, Catch::Contains("--up") && Catch::Contains("-x, -y, -z"));
  CHECK(run_fascia({"run", cube, "--up", "-z", "--steps", "0"}).exit_code == 0);
}
