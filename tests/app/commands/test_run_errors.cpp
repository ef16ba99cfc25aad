// The errors that fascia run --error measures and estimates, and the recovered stress beside that of the tets.
// Covers: run
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("run --error compares the last step with the exact one", "[cli]") {
  const TemporaryFolder folder;
  const std::string stats = (folder / "stats.json").string();
  const auto error = [&](const std::string& iterations) {
    const CommandResult result = run_fascia({"run", cube_path(), "--steps", "5", "--context", "osmesa", "--stats",
                                             stats, "--error", "--set", "solver.iterations=" + iterations});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK(result.err.find("error of the last step") != std::string::npos);
    return nlohmann::json::parse(read_file(stats)).at("error").get<double>();
  };
  const double few = error("2"), many = error("100");
  CAPTURE(few, many);
  CHECK(few > 1e-3);
  CHECK(few < 1);
  CHECK(many < 1e-4);
}

TEST_CASE("run --error tells the errors of solver, time step and mesh apart", "[cli]") {
  const std::string mesh = (source_dir() / "tests/reference/10_dynamic_cantilever/scene.json").string();
  const auto errors = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"run", mesh, "--context", "osmesa", "--error", "--stats", "-"});
    const CommandResult result = run_fascia(more);
    CAPTURE(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK(result.err.find("of the displacement: ") != std::string::npos);
    return nlohmann::json::parse(result.out).at("errors");
  };
  const nlohmann::json euler = errors({"--steps", "20"}),
                       bdf2 = errors({"--steps", "20", "--set", "solver.integrator=bdf2"}),
                       still = errors({"--static"}), exact = errors({"--steps", "2", "--reference"});
  CAPTURE(euler.dump(), bdf2.dump(), still.dump(), exact.dump());
  CHECK(euler.at("solver").get<double>() < 1e-3);
  CHECK(euler.at("time").get<double>() > 5 * bdf2.at("time").get<double>());
  CHECK(euler.at("time_over_run").get<double>() > 0.5 * euler.at("time").get<double>());
  CHECK(euler.at("time_order").get<double>() > 0.5);
  CHECK(euler.at("time_resolved").get<bool>());
  CHECK(euler.at("mesh").get<double>() > 0.02);  // 4,963 linear tets of a beam that bends
  CHECK(euler.at("mesh").get<double>() < 0.5);
  CHECK(euler.at("mesh") != euler.at("mesh_state"));  // of a body with supports that of the motion
  CHECK(euler.at("mesh_over_run").get<double>() > 0.02);
  CHECK(euler.at("peak_stress").at("mesh").get<double>() > 0);
  CHECK(euler.at("peak_stress").at("solver").get<double>() < 1e-3);
  CHECK(euler.at("peak_stress").at("time").get<double>() > 1e-3);
  const double recovered = euler.at("peak_stress").at("recovered_Pa"), tets = euler.at("peak_stress").at("tets_Pa");
  CHECK(tets > 1000);  // of a beam of 2.5e5 Pa that is strained by some percent
  CHECK(recovered != tets);
  CHECK(recovered == Approx(tets).epsilon(0.2));
  CHECK_FALSE(still.contains("solver"));
  CHECK_FALSE(still.contains("time"));
  CHECK_FALSE(still.contains("time_resolved"));
  CHECK_FALSE(still.at("peak_stress").contains("solver"));
  CHECK_FALSE(still.at("peak_stress").contains("time"));
  CHECK(still.at("mesh").get<double>() > 0.02);
  CHECK(still.at("mesh").get<double>() < 0.5);
  CHECK(still.at("mesh") != still.at("mesh_state"));  // that of the equilibrium on finer tets
  CHECK_FALSE(still.contains("mesh_over_run"));
  CHECK_FALSE(exact.contains("solver"));
  CHECK(exact.contains("time"));
  CHECK(exact.contains("mesh_over_run"));
}

TEST_CASE("run --error has the step of a hit, after which the last one is exact", "[cli]") {
  const TemporaryFolder folder;
  const std::string scene = (folder / "scene.json").string();
  nlohmann::json body{{"mesh", (source_dir() / "assets/meshes/cube.msh").string()}, {"initial_velocity", {0, -2, 0}}};
  body["materials"]["default"] = {{"young_modulus", 2e4}, {"poisson_ratio", 0.45}};
  write_file(
      scene,
      nlohmann::json{
          {"fascia_scene", 1}, {"bodies", {body}}, {"ground", {{"height", -0.05}}}, {"solver", {{"iterations", 3}}}}
          .dump());
  const CommandResult result =
      run_fascia({"run", scene, "--steps", "60", "--context", "osmesa", "--error", "--stats", "-"});
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.find("largest error of the solver in 60 steps compared: ") != std::string::npos);
  const nlohmann::json stats = nlohmann::json::parse(result.out), errors = stats.at("errors");
  CHECK(stats.at("error").get<double>() < 1e-3);
  CHECK(errors.at("solver").get<double>() > 0.01);
  CHECK(errors.at("solver_steps") == 60);
  CHECK(errors.at("solver_worst_s").get<double>() < 0.3);  // it meets the ground at 0.025 s
  CHECK(errors.at("mesh").get<double>() >= errors.at("mesh_state").get<double>());
}

// What the forces of the last state would hold is far from a cube that swings down and folds.
TEST_CASE("run --error of a body with supports has the mesh error of its motion, not of its last state", "[cli]") {
  const TemporaryFolder folder;
  const std::string scene = (folder / "scene.json").string();
  nlohmann::json body{{"mesh", (source_dir() / "assets/meshes/cube.msh").string()}};
  body["fixed"].push_back({{"box", {{-1, -1, -1}, {-0.0499, 1, 1}}}});
  body["materials"]["default"] = {
      {"young_modulus", 600}, {"poisson_ratio", 0.4}, {"model", "squared"}, {"density", 1000}};
  write_file(scene,
             nlohmann::json{{"fascia_scene", 1}, {"bodies", {body}}, {"solver", {{"integrator", "bdf2"}}}}.dump());
  const CommandResult result =
      run_fascia({"run", scene, "--steps", "24", "--context", "osmesa", "--error", "--stats", "-"});
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  const nlohmann::json errors = nlohmann::json::parse(result.out).at("errors");
  CAPTURE(errors.dump());
  CHECK(errors.at("mesh").get<double>() < 0.7 * errors.at("mesh_state").get<double>());
}

// Without lateral contraction a cube between plates is stretched uniformly: the Cauchy stress is E l (l^2 - 1) / 2.
TEST_CASE("run --recovered-stress has the stress of a drawn cube in statistics and history, which lack it otherwise",
          "[cli]") {
  const std::string elements = GENERATE("linear", "quadratic");
  const TemporaryFolder folder;
  constexpr double kModulus = 2e4, kStretch = 1.02;
  const double exact = kModulus * kStretch * (kStretch * kStretch - 1) / 2;
  const nlohmann::json held = {{"box", {{-1, -1, -1}, {1, 1e-4, 1}}}},
                       drawn = {{"box", {{-1, 0.1 - 1e-4, -1}, {1, 1, 1}}}};
  nlohmann::json body{{"mesh", (source_dir() / "assets/meshes/cube.msh").string()}, {"elements", elements}};
  body["materials"]["default"] = {{"young_modulus", kModulus}, {"poisson_ratio", 0}};
  body["fixed"].push_back(held);
  body["prescribed"].push_back({{"select", drawn}, {"translate", {0, (kStretch - 1) * 0.1, 0}}, {"duration", 0.02}});
  nlohmann::json scene{{"fascia_scene", 1}, {"gravity", {0, 0, 0}}, {"solver", {{"iterations", 40}}}};
  scene["bodies"].push_back(body);
  write_file(folder / "cube.json", scene.dump());
  const auto run = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"run", "cube.json", "--context", "osmesa", "--stats", "s.json"});
    const CommandResult result = run_fascia(more, folder.path());
    CAPTURE(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK((result.err.find("recovered von Mises stress") != std::string::npos) ==
          (more.back() == "--recovered-stress"));
    return nlohmann::json::parse(read_file(folder / "s.json"));
  };
  const nlohmann::json still = run({"--static", "--recovered-stress"});
  CAPTURE(elements, exact);
  for (const char* key : {"max_von_mises_Pa", "max_recovered_von_mises_Pa", "p99_recovered_von_mises_Pa"}) {
    CAPTURE(key);
    CHECK(still.at(key).get<double>() == Approx(exact).epsilon(1e-3));
  }
  const nlohmann::json moved = run({"--steps", "3", "--history", "h.csv", "--recovered-stress"});
  const std::string history = read_file(folder / "h.csv");
  CHECK(history.find(",max_von_mises_Pa,max_recovered_von_mises_Pa,p99_recovered_von_mises_Pa,momentum_x") !=
        std::string::npos);
  // The last row is of the state that the statistics describe.
  const std::string last = history.substr(history.rfind('\n', history.size() - 2) + 1);
  std::istringstream cells(last);
  std::vector<double> values;
  for (std::string cell; std::getline(cells, cell, ',') && values.size() < 12;) values.push_back(std::stod(cell));
  REQUIRE(values.size() == 12);
  CHECK(values[10] == Approx(moved.at("max_recovered_von_mises_Pa").get<double>()));
  CHECK(values[11] == Approx(moved.at("p99_recovered_von_mises_Pa").get<double>()));
  CHECK(values[11] > 0);
  const nlohmann::json plain = run({"--steps", "1", "--history", "h.csv"});
  CHECK(plain.contains("max_von_mises_Pa"));
  CHECK_FALSE(plain.contains("max_recovered_von_mises_Pa"));
  CHECK(read_file(folder / "h.csv").find("recovered_von_mises_Pa") == std::string::npos);
}
