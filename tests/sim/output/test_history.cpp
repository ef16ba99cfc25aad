// Values over time: the rows of --history against closed forms and the reference solver.
// Covers: sample
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/file.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/output/sample.h"
#include "tests/support/models.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

struct Csv {
  std::vector<std::string> notes;
  std::vector<std::map<std::string, std::string>> rows;
  double at(std::size_t row, const std::string& column) const { return std::stod(rows.at(row).at(column)); }
};

Csv read_csv(const std::filesystem::path& path) {
  Csv csv;
  std::istringstream in(read_file(path));
  std::vector<std::string> names;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("# ", 0) == 0) {
      csv.notes.push_back(line);
      continue;
    }
    std::vector<std::string> cells(1);
    for (const char c : line)
      if (c == ',')
        cells.emplace_back();
      else
        cells.back() += c;
    if (names.empty()) {
      names = cells;
      continue;
    }
    REQUIRE(cells.size() == names.size());
    std::map<std::string, std::string> row;
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = cells[i];
    csv.rows.push_back(row);
  }
  return csv;
}

nlohmann::json body(const char* mesh, double young_modulus, nlohmann::json fixed) {
  return {{"mesh", (source_dir() / "assets/meshes" / mesh).string()},
          {"materials", {{"default", {{"young_modulus", young_modulus}}}}},
          {"fixed", std::move(fixed)}};
}

// Runs with the reference solver, or on the GPU.
void run_in(const TemporaryFolder& folder, std::vector<std::string> arguments, bool reference) {
  if (reference)
    arguments.push_back("--reference");
  else
    arguments.insert(arguments.end(), {"--context", "osmesa"});
  const CommandResult run = run_fascia(arguments, folder.path());
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
}

}  // namespace

TEST_CASE("the history of the reference solver has the force of a grab, that of its spring") {
  const Model model =
      make_model(make_box(4, 2, 2, {0.2, 0.1, 0.1}), {1e5, 0.3, 1000, 0, MaterialModel::st_venant_kirchhoff},
                 [](const Eigen::Vector3d& x) { return x.x() < 1e-9; });
  Simulation simulation(Scene{}, model, nullptr, true);
  const std::uint32_t tip = tip_vertex(model);
  const Eigen::Vector3d target(0, 0.05, 0);
  constexpr double kStiffness = 40;  // [N/m]
  simulation.set_grab({{tip, target, kStiffness}});
  for (int i = 0; i < 3; ++i) simulation.step();
  const Sample sample = sample_now(simulation, tip);
  const Eigen::Vector3d expected = kStiffness * (target - simulation.state().displacement[tip]);
  CAPTURE(sample.grab.transpose(), expected.transpose());
  CHECK(expected.norm() > 0.5);
  CHECK((sample.grab - expected).norm() < 1e-12 * expected.norm());
}

TEST_CASE(
    "the recovered stress of a bar that is drawn or bent is that of the closed form, in linear and quadratic tets") {
  const bool bent = GENERATE(false, true), ten_nodes = GENERATE(false, true);
  constexpr double kModulus = 1e5, kRate = 1e-3, kHeight = 0.1;
  Model model = make_model(make_box(16, 8, 8, {0.2, kHeight, kHeight}),
                           {kModulus, 0, 1000, 0, MaterialModel::st_venant_kirchhoff},
                           [](const Eigen::Vector3d&) { return true; });
  if (ten_nodes) model = quadratic(model);
  Simulation simulation(Scene{}, model, nullptr, true);
  State state = simulation.state();
  for (std::size_t v = 0; v < state.displacement.size(); ++v) {
    const Eigen::Vector3d x = model.rest_positions[v];
    state.displacement[v] =
        bent ? Eigen::Vector3d(kRate * x.x() * (x.y() - 0.5 * kHeight), -0.5 * kRate * x.x() * x.x(), 0)
             : Eigen::Vector3d(kRate * x.x(), 0, 0);
  }
  simulation.go_on_from(state);
  Sample sample = sample_now(simulation, 0);
  CHECK(std::isnan(sample.max_recovered));
  measure_recovered(sample, simulation);
  // Without lateral contraction: E l (l^2 - 1) / 2 with the stretch l, in bending E times the strain to first order.
  const double exact = bent ? 0.5 * kModulus * kRate * kHeight : 0.5 * kModulus * (1 + kRate) * (2 + kRate) * kRate;
  CAPTURE(bent, ten_nodes, sample.max_von_mises / exact, sample.max_recovered / exact, sample.p99_recovered / exact);
  CHECK(sample.p99_recovered == Approx(exact).epsilon(bent ? 0.02 : 1e-9));
  // At single vertices the fit to linear tets overshoots, by a fifth in docs/concepts/accuracy.md.
  const bool overshoots = bent && !ten_nodes;
  CHECK(sample.max_recovered == Approx(exact).epsilon(overshoots ? 0.2 : bent ? 0.02 : 1e-9));
}

TEST_CASE("history of a free fall: implicit Euler's energies and momentum in closed form") {
  const TemporaryFolder folder;
  const nlohmann::json scene{{"fascia_scene", 1},
                             {"bodies", {body("cube.msh", 1e5, nlohmann::json::array())}},
                             {"solver", {{"time_step", 0.01}}}};
  write_file(folder / "fall.json", scene.dump());
  const bool reference = GENERATE(false, true);
  CAPTURE(reference);
  run_in(folder, {"run", "fall.json", "--steps", "20", "--history", "fall.csv", "--history-every", "5", "--probe", "3"},
         reference);
  const Csv csv = read_csv(folder / "fall.csv");
  REQUIRE(csv.rows.size() == 5);
  CHECK(csv.notes.back() == "# Probe: vertex 3");
  CHECK(csv.rows[0].at("residual").empty());
  CHECK(csv.rows[0].at("step_ms").empty());
  const double g = 9.81, h = 0.01;
  const double mass = 1000 * 1e-3;  // of a cube of 0.1 m
  // Float32 has seven digits of displacement and velocity; their rounding accumulates over the steps.
  const double digits = reference ? 1e-9 : 2e-5;
  for (std::size_t i = 1; i < csv.rows.size(); ++i) {
    const double n = 5.0 * static_cast<double>(i), v = n * g * h, fallen = 0.5 * g * h * h * n * (n + 1);
    CAPTURE(n);
    CHECK(csv.at(i, "step") == n);
    CHECK(csv.at(i, "time_s") == Approx(n * h));
    CHECK(csv.at(i, "kinetic_J") == Approx(0.5 * mass * v * v).epsilon(digits));
    CHECK(csv.at(i, "gravitational_J") == Approx(-mass * g * fallen).epsilon(digits));
    // Implicit Euler loses m g^2 h^2 / 2 per step; small relative to the energies that cancel in it.
    CHECK(csv.at(i, "total_J") == Approx(-0.5 * mass * g * g * h * h * n).margin(2 * digits * 0.5 * mass * v * v));
    CHECK(csv.at(i, "momentum_y_kg_m_s") == Approx(-mass * v).epsilon(digits));
    CHECK(csv.at(i, "probe_y_m") == Approx(-fallen).epsilon(digits));
    CHECK(csv.at(i, "volume_ratio") == Approx(1).margin(1e-5));
    CHECK(csv.at(i, "step_ms") > 0);
    CHECK(csv.rows[i].at("frame_ms").empty());
  }
}

TEST_CASE("history on the GPU equals that of the reference solver") {
  const TemporaryFolder folder;
  const std::string elements = GENERATE("linear", "quadratic");
  nlohmann::json cube = body("cube.msh", 2e4, {{{"group", "clamp"}}});
  cube["elements"] = elements;
  nlohmann::json scene{{"fascia_scene", 1}, {"solver", {{"iterations", 40}}}};
  scene["bodies"].push_back(cube);
  write_file(folder / "cube.json", scene.dump());
  for (const bool reference : {false, true})
    run_in(folder, {"run", "cube.json", "--steps", "6", "--history", reference ? "cpu.csv" : "gpu.csv"}, reference);
  const Csv gpu = read_csv(folder / "gpu.csv"), cpu = read_csv(folder / "cpu.csv");
  REQUIRE(gpu.rows.size() == 7);
  REQUIRE(cpu.rows.size() == 7);
  CHECK(gpu.notes.back() == cpu.notes.back());
  for (std::size_t i = 1; i < gpu.rows.size(); ++i)
    for (const char* column : {"time_s", "kinetic_J", "elastic_J", "gravitational_J", "reaction_y_N", "probe_y_m",
                               "max_strain", "max_von_mises_Pa"}) {
      CAPTURE(elements, i, column);
      CHECK(gpu.at(i, column) == Approx(cpu.at(i, column)).epsilon(1e-3));
    }
}

TEST_CASE("history of a stretched cube lists its supports separately, on the GPU and by the reference solver") {
  const TemporaryFolder folder;
  nlohmann::json cube = body("cube.msh", 2e4, {{{"group", "clamp"}}});
  cube["prescribed"] = {
      {{"select", {{"box", {{-1, -1, -1}, {1, 1e-4, 1}}}}}, {"translate", {0, -0.02, 0}}, {"duration", 0.1}}};
  write_file(
      folder / "cube.json",
      nlohmann::json{{"fascia_scene", 1}, {"gravity", {0, 0, 0}}, {"bodies", {cube}}, {"solver", {{"iterations", 40}}}}
          .dump());
  const bool reference = GENERATE(false, true);
  CAPTURE(reference);
  run_in(folder, {"run", "cube.json", "--steps", "6", "--history", "h.csv", "--stats", "s.json"}, reference);
  const Csv csv = read_csv(folder / "h.csv");
  REQUIRE(csv.rows.size() == 7);
  REQUIRE(csv.notes.size() >= 2);
  CHECK(csv.notes[csv.notes.size() - 2].find("# Support 0: ") == 0);
  CHECK_THAT(csv.notes.back(), Catch::Contains("# Support 1: ") && Catch::Contains(", prescribed 0"));
  CHECK(csv.at(1, "support_1_y_N") < -1);
  CHECK(csv.at(1, "support_0_y_N") > 1);
  for (std::size_t i = 1; i < csv.rows.size(); ++i) {
    const double held = csv.at(i, "support_0_y_N"), pulled = csv.at(i, "support_1_y_N");
    CAPTURE(i, held, pulled, csv.at(i, "reaction_y_N"));
    CHECK(held + pulled == Approx(csv.at(i, "reaction_y_N")).margin(1e-3 * (std::abs(held) + std::abs(pulled))));
  }
  const auto supports = nlohmann::json::parse(read_file(folder / "s.json")).at("reaction_N").at("supports");
  REQUIRE(supports.size() == 2);
  CHECK(supports[0].at("fixed") == true);
  CHECK(supports[1].at("prescribed") == 0);
  CHECK(supports[1].at("force")[1].get<double>() == Approx(csv.at(6, "support_1_y_N")));
}

TEST_CASE("the tip is the free vertex farthest from the supports") {
  const Material soft{2e4, 0.35, 1050, 0, MaterialModel::st_venant_kirchhoff};
  const TetMesh mesh = make_box(8, 2, 2, {0.4, 0.1, 0.1});
  const Model cantilever = make_model(mesh, soft, [](const Eigen::Vector3d& x) { return x.x() < 1e-9; });
  CHECK(cantilever.rest_positions[tip_vertex(cantilever)].x() == Approx(0.4));
  const Model bridge =
      make_model(mesh, soft, [](const Eigen::Vector3d& x) { return x.x() < 1e-9 || x.x() > 0.4 - 1e-9; });
  CHECK(bridge.rest_positions[tip_vertex(bridge)].x() == Approx(0.2));
}

TEST_CASE("contradictory history options are refused in one line") {
  const TemporaryFolder folder;
  const std::string scene = (source_dir() / "assets/scenes/cube.json").string();
  const CommandResult far = run_fascia(
      {"run", scene, "--context", "osmesa", "--steps", "1", "--history", "h.csv", "--probe", "999999"}, folder.path());
  CHECK(far.exit_code == 1);
  CHECK_THAT(far.err, Catch::Contains("--probe 999999: is not a vertex of this scene; expected an index below 177"));
  const CommandResult still = run_fascia({"run", scene, "--static", "--history", "h.csv"}, folder.path());
  CHECK(still.exit_code == 2);
  CHECK_THAT(still.err, Catch::Contains("--history: has no steps to follow with --static"));
  CHECK(run_fascia({"run", scene, "--probe", "3"}, folder.path()).exit_code == 2);
  CHECK_FALSE(std::filesystem::exists(folder / "h.csv"));
}
