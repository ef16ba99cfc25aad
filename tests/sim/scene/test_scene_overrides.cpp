// --set: the keys that it changes and creates, and that its errors differ from the file's.
#include "sim/scene/scene_overrides.h"
#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using namespace fascia::test;

namespace {

Scene with(const std::vector<std::string>& overrides, const std::string& text = scene_text()) {
  return SceneFile(text).open(overrides);
}
std::string error_with(const std::vector<std::string>& overrides, const std::string& text = scene_text()) {
  return SceneFile(text).open_error(overrides);
}

}  // namespace

TEST_CASE("an override replaces the file's value") {
  const std::string text = scene_text(R"("materials": {"default": {"young_modulus": 1e6}, "2": {"density": 900}},
                                         "fixed": [{"box": [[0, 0, 0], [1, 1, 1]]}])",
                                      R"("gravity": [0, -1, 0], "solver": {"iterations": 5, "substeps": 2})");
  const Scene before = with({}, text);
  Scene expected = before;
  CHECK(with({"solver.iterations=40"}, text).solver.iterations == 40);
  expected.solver.iterations = 40;
  expected.file = "";
  Scene after = with({"solver.iterations=40"}, text);
  after.file = "";
  CHECK(after == expected);  // only this key
  CHECK(with({"gravity=[0,0,0]"}, text).gravity == Eigen::Vector3d(0, 0, 0));
  CHECK(with({"gravity.1=-2.5"}, text).gravity == Eigen::Vector3d(0, -2.5, 0));
  CHECK(with({"bodies.0.materials.2.young_modulus=2e5"}, text).bodies[0].region_materials[0].second ==
        MaterialOverride{2e5, {}, 900, {}, {}});
  CHECK(with({"materials.default.poisson_ratio=0.4"}, text).bodies[0].material.poisson_ratio == 0.4);
  CHECK(with({"fixed.0.box.1.0=0.5"}, text).bodies[0].fixed[0] == Selection(BoxSelection{{0, 0, 0}, {0.5, 1, 1}}));
  CHECK(with({"fixed=[]"}, text).bodies[0].fixed.empty());
  CHECK(with({"title=Two words"}, text).title == "Two words");
  CHECK(with({"title=\"5\""}, text).title == "5");
  CHECK(with({"title=a=b"}, text).title == "a=b");
  CHECK(with({"bodies.0.mesh=../other.msh"}, text).bodies[0].mesh == "../other.msh");
}

TEST_CASE("an override creates keys that the file does not have") {
  CHECK(with({"solver.substeps=4"}).solver.substeps == 4);
  CHECK(with({"display.color=strain"}).display.color == ColorBy::strain);
  CHECK(with({"display.range=[0,0.5]"}).display.range == Eigen::Vector2d(0, 0.5));
  CHECK(with({"gravity.1=-1.62"}).gravity == Eigen::Vector3d(0, -1.62, 0));
  CHECK(with({"transform.translate.1=2"}).bodies[0].transform.translate == Eigen::Vector3d(0, 2, 0));
  CHECK(with({"bodies.0.transform.scale=0.001"}).bodies[0].transform.scale == 0.001);
  CHECK(with({"bodies.0.initial_velocity.2=3"}).bodies[0].initial_velocity ==
        std::variant<Eigen::Vector3d, std::string>(Eigen::Vector3d(0, 0, 3)));
  CHECK(with({"camera.eye.0=3"}).camera->eye == Eigen::Vector3d(3, 0.3, 1));
  const Body body = with({"materials.2.young_modulus=2e5", "materials.tumour.density=1100"}).bodies[0];
  REQUIRE(body.region_materials.size() == 2);
  CHECK(body.region_materials[0].first == "2");
  CHECK(body.region_materials[0].second.young_modulus == 2e5);
  CHECK(body.region_materials[1].first == "tumour");
  CHECK(body.region_materials[1].second.density == 1100.0);
  CHECK(with({"fixed.0.lowest=0.1"}).bodies[0].fixed == std::vector<Selection>{LowestSelection{0.1}});
  CHECK(with({"fixed.0.vertices.0=7", "fixed.0.vertices.1=9"}).bodies[0].fixed ==
        std::vector<Selection>{VertexSelection{{7, 9}}});
  const auto motions =
      with({"prescribed.0.select.group=end", "prescribed.0.translate.0=0.1", "prescribed.0.rotate_deg.angle=90"})
          .bodies[0]
          .prescribed;
  REQUIRE(motions.size() == 1);
  CHECK(motions[0].select == Selection(GroupSelection{"end"}));
  CHECK(motions[0].translate == Eigen::Vector3d(0.1, 0, 0));
  CHECK(motions[0].angle_deg == 90);
  CHECK(with({"bodies.1.mesh=second.msh"}).bodies[1].mesh == "second.msh");
}

TEST_CASE("a path may be written in the form of errors") {
  CHECK(with({"bodies[0].transform.translate[1]=2"}).bodies[0].transform.translate == Eigen::Vector3d(0, 2, 0));
}

TEST_CASE("a key is a path from the top of the scene") {
  const std::vector<std::string> mesh{"bodies", "0", "mesh"};
  CHECK(segments_of("bodies[0].mesh") == mesh);
  CHECK(segments_of("bodies.0.mesh") == mesh);
  CHECK(segments_of("mesh") == mesh);
  CHECK(segments_of("gravity.1") == std::vector<std::string>{"gravity", "1"});
  CHECK(segments_of("gravity..1").empty());
}

TEST_CASE("an override may be a number as people write it") {
  const auto [text, value] = GENERATE(table<std::string, double>(
      {{".25", 0.25}, {"+.25", 0.25}, {"1.", 1}, {"+1", 1}, {"25e-2", 0.25}, {".25e0", 0.25}}));
  CAPTURE(text);
  CHECK(with({"materials.default.damping=" + text}).bodies[0].material.damping == value);
  for (const std::string wrong : {".", "+", "1.2.3", "nan", "inf", "+-1", "0x1"}) {
    CAPTURE(wrong);
    CHECK(error_with({"materials.default.damping=" + wrong}).find("expected a number") != std::string::npos);
  }
}

TEST_CASE("the last override wins") {
  CHECK(with({"solver.iterations=3", "solver.iterations=4"}).solver.iterations == 4);
  CHECK(with({"solver={\"iterations\": 3}", "solver.substeps=4"}).solver.iterations == 3);
}

TEST_CASE("an override repairs an error of the file") {
  CHECK(with({"solver.method=jacobi"}, scene_text("", R"("solver": {"method": "multigrid"})")).solver.method ==
        Method::jacobi);
  CHECK(with({"materials.default.young_modulus=1e5"}, scene_text(R"("materials": {"default": {"young_modulus": 0}})"))
            .bodies[0]
            .material.young_modulus == 1e5);
}

TEST_CASE("overrides apply to a mesh opened on its own") {
  const SceneFile mesh("$MeshFormat", "liver.msh");
  const Scene scene = mesh.open({"materials.default.young_modulus=3e4", "gravity.1=-1", "solver.iterations=3",
                                 "display.color=von_mises", "transform.scale=0.001", "fixed.0.lowest=0.1"});
  CHECK(scene.bodies[0].material.young_modulus == 3e4);
  CHECK(scene.gravity == Eigen::Vector3d(0, -1, 0));
  CHECK(scene.solver.iterations == 3);
  CHECK(scene.display.color == ColorBy::von_mises);
  CHECK(scene.bodies[0].transform.scale == 0.001);
  CHECK(scene.bodies[0].fixed == std::vector<Selection>{LowestSelection{0.1}});
  CHECK(mesh.open_error({"materials.default.young_modulus=0"}) ==
        "--set materials.default.young_modulus: is 0; expected 0.001 to 1e+14 Pa");
}

TEST_CASE("an error of an override names the override, one of the file the file") {
  CHECK(error_with({"solver.iteration=3"}) ==
        "--set solver.iteration: unknown key \"iteration\", perhaps \"iterations\"; expected one of method, "
        "acceleration, integrator, iterations, tolerance, time_step, substeps, frame_budget, colors, spectral_radius, "
        "window, "
        "rest_speed");
  CHECK(error_with({"bodies.0.material.young_modulus=3"}) ==
        "--set bodies.0.material.young_modulus: bodies[0].material: unknown key \"material\", perhaps \"materials\"; "
        "expected one of name, mesh, resolution, elements, unit, up, transform, materials, regions, fixed, prescribed, "
        "initial_velocity, surface");
  CHECK(error_with({"solver.iterations=0"}) == "--set solver.iterations: is 0; expected a whole number, 1 to 10000");
  CHECK(error_with({"solver={\"iterations\": 0}"}) ==
        "--set solver: solver.iterations: is 0; expected a whole number, 1 to 10000");
  CHECK(error_with({"solver.tolerance=nan"}) == "--set solver.tolerance: is \"nan\"; expected a number, 0 to 1");
  CHECK(error_with({"solver.method=multigrid"}) ==
        "--set solver.method: is \"multigrid\"; expected a method and acceleration that exist: " + list_of_choices());
  CHECK(error_with({"materials.2.density=-1"}) == "--set materials.2.density: is -1; expected 0.001 to 1e+06 kg/m^3");
  CHECK(error_with({"materials.young_modulus=3"}) ==
        "--set materials.young_modulus: is 3; expected an object such as {\"young_modulus\": 1e5}, under \"default\", "
        "a region number or a group name");
  CHECK(error_with({"camera.fov_deg=30"}) ==
        "--set camera.fov_deg: camera.eye: is missing; expected a list of 3 numbers [m] (without a camera the view is "
        "framed on the bodies)");
  const std::string wrong = scene_text("", R"("solver": {"iterations": 0})");
  CHECK(error_with({"solver.substeps=2"}, wrong) ==
        "s.json: solver.iterations: is 0; expected a whole number, 1 to 10000");
  // Of two overrides of the same value, the last is wrong.
  CHECK(error_with({"solver={}", "solver.iterations=-1"}) ==
        "--set solver.iterations: is -1; expected a whole number, 1 to 10000");
}

TEST_CASE("an unknown key at the beginning of an override suggests keys of scenes, of bodies, and of objects in them") {
  const std::string known =
      "; expected one of bodies, camera, contact, display, duration, fascia_scene, grabs, gravity, ground, "
      "instruments, "
      "obstacles, solver, title, elements, fixed, initial_velocity, materials, mesh, name, prescribed, regions, "
      "resolution, surface, transform and 2 more";
  const auto unknown = [&](const std::string& key, const std::string& word, const std::string& near) {
    CHECK(error_with({key + "=1"}) == "--set " + key + ": unknown key \"" + word + "\"" +
                                          (near.empty() ? "" : ", perhaps \"" + near + "\"") + known);
  };
  unknown("Gravity", "Gravity", "gravity");
  unknown("solvr.iterations", "solvr", "solver");
  unknown("material.default.density", "material", "materials");
  unknown("Materials.default.density", "Materials", "materials");
  unknown("initialVelocity", "initialVelocity", "initial_velocity");
  unknown("iterations", "iterations", "solver.iterations");
  unknown("young-modulus", "young-modulus", "materials.default.young_modulus");
  unknown("color", "color", "display.color");
  unknown("qqq", "qqq", "");
  // A key in the file is the file's own error.
  CHECK(error_with({"strange=1"}, scene_text("", R"("strange": 2)")).find("--set strange: unknown key") == 0);
}

TEST_CASE("texts that are no override, and paths that lead nowhere") {
  const std::string expected = "; expected KEY=VALUE such as solver.iterations=40";
  CHECK(error_with({"foo"}) == "--set foo: has no =" + expected);
  CHECK(error_with({""}) == "--set : has no =" + expected);
  CHECK(error_with({"=3"}) == "--set =3: has no key" + expected);
  CHECK(error_with({"solver..iterations=3"}) == "--set solver..iterations=3: has no key" + expected);
  CHECK(
      error_with({"bodies.2.mesh=x"}) ==
      "--set bodies.2.mesh: \"2\" is not an element of bodies, which has 1; expected 0 to 1 (the end: a new element)");
  CHECK(error_with({"gravity.x=1"}) ==
        "--set gravity.x: \"x\" is not an element of gravity, which has 3; expected 0 to 3 (the end: a new element)");
  CHECK(error_with({"gravity.99999999999999999999=1"}) ==
        "--set gravity.99999999999999999999: \"99999999999999999999\" is not an element of gravity, which has 3; "
        "expected "
        "0 to 3 (the end: a new element)");
  CHECK(error_with({"gravity.3=1"}) ==
        "--set gravity.3: gravity: is [0,-9.81,0,1]; expected a list of 3 numbers [m/s^2]");
  CHECK(error_with({"fascia_scene.foo=1"}) == "--set fascia_scene.foo: fascia_scene is 1; expected no key below it");
  CHECK(error_with({"title.0=a"}) == "--set title.0: title: is [\"a\"]; expected a text");
}
