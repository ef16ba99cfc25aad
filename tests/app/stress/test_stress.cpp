// The stress suite: its criteria fail where they should, and the files of a failure reproduce it.
// Covers: run, app/commands/stress
#include <catch2/catch.hpp>

#include "app/session/graphics.h"
#include "app/stress/stress.h"
#include "base/file.h"
#include "sim/grab/build_model.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/simulation/simulation.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

struct Box {
  TemporaryFolder folder;
  Graphics graphics;
  Scene scene;
  Box() {
    CommonOptions options;
    options.context = "osmesa";
    graphics = open_graphics(options, false);
    write_mesh(folder / "box.msh", make_box(2, 2, 2, {0.2, 0.2, 0.2}));
    scene.file = folder / "box.json";
    scene.gravity.setZero();
    Body body;
    body.name = "box";
    body.mesh = "box.msh";
    body.material.young_modulus = 1e6;
    scene.bodies.push_back(body);
  }
  void clamp() { scene.bodies[0].fixed.push_back(BoxSelection{{-1e-6, -1, -1}, {1e-6, 1, 1}}); }
  std::string failure(const StressCriteria& criteria, std::optional<State> start = std::nullopt, long steps = 5) {
    Simulation simulation(scene, graphics.programs.get(), false);
    simulation.play({scene, std::move(start), {}, steps});
    const StressResult result = run_stress_case(simulation, criteria);
    std::string all;
    for (const std::string& failure : result.failures) all += failure + "|";
    return all;
  }
};

StressCriteria nothing() {
  StressCriteria criteria;
  criteria.farthest = 1e9;
  criteria.keeps_upright = false;
  return criteria;
}

}  // namespace

TEST_CASE("every criterion of the stress suite can fail") {
  Box box;
  StressCriteria criteria = nothing();

  SECTION("at rest all criteria hold") {
    box.clamp();
    CHECK(box.failure({1e-9, true, true, true, true, true, true}) == "");
  }
  SECTION("distance") {
    box.scene.bodies[0].initial_velocity = Vector3d(60, 0, 0);
    CHECK(box.failure(criteria) == "");
    criteria.farthest = 3;
    CHECK_THAT(box.failure(criteria), Catch::StartsWith("moved by 14.4 sizes"));
  }
  SECTION("rest shape") {
    box.clamp();
    box.scene.gravity = {0, -1000, 0};
    CHECK(box.failure(criteria) == "");
    criteria.recovers = true;
    CHECK_THAT(box.failure(criteria), Catch::StartsWith("off its rest shape by "));
  }
  SECTION("energy") {
    box.clamp();
    PrescribedMotion pull;
    pull.select = BoxSelection{{0.2 - 1e-6, -1, -1}, {0.2 + 1e-6, 1, 1}};
    pull.translate = {0.1, 0, 0};
    box.scene.bodies[0].prescribed.push_back(pull);
    State start = initial_state(build_model(box.scene));
    start.displacement[13] = {0.01, 0, 0};  // some energy to compare with
    CHECK(box.failure(criteria, start) == "");
    criteria.creates_no_energy = true;
    CHECK_THAT(box.failure(criteria, start), Catch::StartsWith("energy grew by "));
  }
  SECTION("momentum") {
    box.scene.bodies[0].initial_velocity = Vector3d(0.1, 0, 0);
    box.scene.gravity = {0, -9.81, 0};
    CHECK(box.failure(criteria) == "");
    criteria.creates_no_momentum = true;
    CHECK_THAT(box.failure(criteria), Catch::StartsWith("momentum grew by "));
  }
  SECTION("energy that is left at rest") {
    box.scene.bodies[0].initial_velocity = Vector3d(1, 0, 0);
    CHECK(box.failure(criteria) == "");
    criteria.springs_back = true;
    CHECK_THAT(box.failure(criteria), Catch::StartsWith("keeps 4 J of "));
  }
  SECTION("weight that is not carried yet") {
    box.clamp();
    box.scene.gravity = {0, -1000, 0};
    criteria.carries_its_weight = true;
    CHECK_THAT(box.failure(criteria, std::nullopt, 1), Catch::StartsWith("moves with "));
  }
  SECTION("elastic energy that no weight has stored") {
    box.clamp();
    State start = initial_state(build_model(box.scene));
    for (Vector3d& u : start.displacement) u = Vector3d::Zero();
    start.displacement[13] = {0.02, 0, 0};
    criteria.carries_its_weight = true;
    CHECK_THAT(box.failure(criteria, start, 1), Catch::StartsWith("elastic energy of "));
  }
  SECTION("inverted tets: plain St. Venant-Kirchhoff is at rest when mirrored") {
    box.scene.bodies[0].material.model = MaterialModel::st_venant_kirchhoff;
    const Model model = build_model(box.scene);
    State mirrored = initial_state(model);
    for (std::size_t v = 0; v < mirrored.displacement.size(); ++v)
      mirrored.displacement[v].x() = -2 * model.rest_positions[v].x();
    CHECK(box.failure(criteria, mirrored) == "");
    criteria.keeps_upright = true;
    CHECK(box.failure(criteria, mirrored) == "48 tets inside out at the end|");
    box.scene.bodies[0].material.model = MaterialModel::signed_st_venant_kirchhoff;
    CHECK(box.failure(criteria, mirrored, 60) == "");
  }
  SECTION("finite values") {
    box.clamp();
    State start = initial_state(build_model(box.scene));
    start.displacement[13] = {1e25, 0, 0};
    CHECK(box.failure(criteria, start) == "not finite after 1 steps|");
  }
}

TEST_CASE("a failure writes a table, a summary, a picture and a replay that reproduces it") {
  TemporaryFolder folder;
  const auto stress = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"stress", "--quick", "--context", "osmesa", "--out", (folder / "out").string(),
                                       "--size", "96x64"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_fascia(arguments, folder.path());
  };
  const std::string only = "start/mirrored E=1e+06/two_level + subspace";
  const CommandResult passed = stress({"--only", only});
  CAPTURE(passed.err);
  CHECK(passed.exit_code == 0);
  CHECK_THAT(read_file(folder.path() / "out" / "stress.csv"),
             Catch::Contains("start,mirrored E=1e+06,two_level,subspace,1,"));
  CHECK_THAT(read_file(folder.path() / "out" / "summary.md"),
             Catch::Contains("| two_level + subspace | 1 / 1 | 1 / 1 |"));

  const CommandResult failed = stress({"--only", only, "--model", "st_venant_kirchhoff"});
  CAPTURE(failed.err);
  CHECK(failed.exit_code == 1);
  CHECK_THAT(failed.err, Catch::Contains("FAILED start/mirrored E=1e+06/two_level + subspace: "));
  const auto replay = folder.path() / "out" / "failures" / "start_mirrored_E_1e_06_two_level___subspace.fascia";
  CHECK(std::filesystem::exists(std::filesystem::path(replay).replace_extension(".png")));
  const CommandResult again =
      run_fascia({"run", "--replay", replay.string(), "--context", "osmesa", "--stats", "stats.json"}, folder.path());
  CAPTURE(again.err);
  CHECK(again.exit_code == 0);
  CHECK_THAT(again.err, Catch::Contains(" inside out at the end\n"));
  CHECK_THAT(read_file(folder / "stats.json"),
             Catch::Contains("\"steps\": 150") && !Catch::Contains("\"inverted\": 0,"));

  const CommandResult curved = stress({"--only", "mesh/cap/", "--integrator", "sdirk2", "--elements", "quadratic"});
  CAPTURE(curved.err);
  const std::string table = read_file(folder.path() / "out" / "stress.csv");
  CHECK_THAT(table, Catch::Contains("mesh,cap,two_level,subspace,") && Catch::Contains(",sdirk2,quadratic,"));
  CHECK_THAT(table, !Catch::Contains("vertex_descent"));

  const CommandResult none = stress({"--only", "no such case"});
  CHECK(none.exit_code == 1);
  CHECK_THAT(
      none.err,
      Catch::EndsWith("--only no such case: matches no case; expected a part of group/case/method + acceleration\n"));
}
