// Scripted grabs of a scene: against the reference solver, in replays, with sleeping tissue, on the command line.
#include <catch2/catch.hpp>

#include "app/session/graphics.h"
#include "app/session/open_input.h"
#include "base/file.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/simulation/simulation.h"
#include "tests/support/headless.h"
#include "tests/support/models.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

// The shipped cube on its clamped base, pulled by two grabs of the scene at its top.
struct Handled {
  explicit Handled(const std::string& grabs) {
    write_file(folder / "cube.json",
               R"({"fascia_scene": 1, "gravity": [0, 0, 0], "bodies": [{"name": "cube", "mesh": ")" +
                   (source_dir() / "assets/meshes/cube.msh").string() +
                   R"(", "materials": {"default": {"young_modulus": 2e4, "damping": 0.05}},
                                         "fixed": [{"lowest": 0.02}]}], "grabs": )" +
                   grabs + "}");
  }
  TemporaryFolder folder;
  Scene scene() const { return open_scene(folder / "cube.json"); }
};

constexpr const char* kTwo =
    R"([{"select": {"box": [[0.001, 0.09, -1], [1, 1, 1]]}, "translate": [0.02, 0.01, 0], "duration": 0.2},
                                 {"select": {"box": [[-1, 0.09, -1], [0, 1, 1]]}, "translate": [-0.01, 0, 0.01], "start": 0.1, "release": 0.3}])";

}  // namespace

TEST_CASE("grabs of a scene pull the GPU as they pull the reference solver") {
  const Handled cube(kTwo);
  Graphics graphics = open_graphics(headless(), false);
  Simulation gpu(cube.scene(), graphics.programs.get(), false), exact(cube.scene(), nullptr, true);
  SolverSettings settings = gpu.scene.solver;
  settings.iterations = 40;
  gpu.set_settings(settings);
  std::vector<std::size_t> grabs;
  for (int i = 0; i < 24; ++i) {
    gpu.step();
    exact.step();
    CHECK(gpu.springs() == exact.springs());
    std::size_t count = 0;
    for (const GrabSpring& s : gpu.springs()) count = std::max<std::size_t>(count, s.grab - kFirstScriptedGrab + 1);
    grabs.push_back(count);
  }
  CHECK(grabs.front() == 1);
  CHECK(grabs[12] == 2);
  CHECK(grabs.back() == 1);  // released
  CAPTURE(relative_rms(gpu.state().displacement, exact.state().displacement));
  CHECK(relative_rms(gpu.state().displacement, exact.state().displacement) < 1e-3);
  CHECK(gpu.log().inputs().size() <= 1);  // the settings: actions of the scene are not inputs

  // To equilibrium with all of them at the end of their paths.
  Simulation still(cube.scene(), graphics.programs.get(), false), newton(cube.scene(), nullptr, true);
  CHECK(still.solve_static().converged);
  newton.solve_static();
  CHECK(relative_rms(still.state().displacement, newton.state().displacement) < 1e-4);
  const Vector3d reaction = reference::measure(newton.model, newton.state()).fixed_reaction;
  Vector3d pull(0, 0, 0);
  for (const GrabForce& f : forces_of_grabs(newton.springs(), newton.state().displacement)) pull += f.force;
  CHECK(pull.norm() > 1e-3);
  CHECK((reaction + pull).norm() < 1e-8 * pull.norm());
}

// With a traction T on the end, u = T L / E there, and the stress is T everywhere (nu = 0).
TEST_CASE("a grab that selects the end of a bar stretches it evenly") {
  const std::string elements = GENERATE("linear", "quadratic");
  TemporaryFolder folder;
  write_mesh(folder / "bar.msh", make_box(6, 2, 2, {0.3, 0.1, 0.1}));
  write_file(folder / "bar.json",
             R"({"fascia_scene": 1, "gravity": [0, 0, 0], "bodies": [{"mesh": "bar.msh", "elements": ")" + elements +
                 R"(", "materials": {"default": {"young_modulus": 1e5, "poisson_ratio": 0,
      "model": "st_venant_kirchhoff"}}, "fixed": [{"box": [[-1, -1, -1], [1e-6, 1, 1]]}]}],
      "grabs": [{"select": {"box": [[0.2999, -1, -1], [1, 1, 1]]}, "translate": [0.003, 0, 0], "stiffness": 500}]})");
  Simulation bar(open_scene(folder / "bar.json"), nullptr, true);
  REQUIRE(bar.solve_static().converged);
  double least = 1, most = 0;
  for (std::size_t v = 0; v < bar.model.rest_positions.size(); ++v)
    if (bar.model.rest_positions[v].x() > 0.2999) {
      least = std::min(least, bar.state().displacement[v].x());
      most = std::max(most, bar.state().displacement[v].x());
    }
  const reference::Measures measures = reference::measure(bar.model, bar.state());
  CAPTURE(elements, least, most, measures.max_von_mises);
  CHECK(most - least < 1e-6 * most);
  CHECK(most == Approx(500 * 0.003 / (500 + 1e5 * 0.01 / 0.3)).epsilon(5e-3));  // apart from the stretch squared
  CHECK(measures.max_von_mises == Approx(1e5 * most / 0.3).epsilon(5e-3));
}

TEST_CASE("a replay repeats grabs of the mouse in addition to those of its scene to the bit, once") {
  const Handled cube(kTwo);
  Graphics graphics = open_graphics(headless(), false);
  Simulation lived(cube.scene(), graphics.programs.get(), false);
  Replay replay{cube.scene(), std::nullopt, {}, 20};
  const std::vector<std::uint32_t> patch = [&] {
    std::vector<std::uint32_t> vertices;
    for (const GrabSpring& s : lived.model.grabs[0].grip) vertices.push_back(s.vertex);
    return vertices;
  }();
  for (int i = 0; i < 20; ++i) {
    GrabInput springs;  // two grabs of the mouse, which begin one after the other at the place of the scene's grab
    if (i >= 3) springs.push_back({patch[0], {0, 0, 0.001 * i}, 40, 0});
    if (i >= 8 && i < 15)
      for (const std::uint32_t v : patch) springs.push_back({v, {0.0005 * i, 0, 0}, 5, 1});
    replay.inputs.push_back({lived.steps_made(), springs});
    lived.set_grab(springs);
    lived.gpu()->finish_background();
    lived.step();
  }
  write_replay(cube.folder / "lived.fascia", replay);
  Opened opened = open_file(cube.folder / "lived.fascia");
  CHECK(opened.replay->inputs == replay.inputs);
  Simulation again(std::move(opened.scene), graphics.programs.get(), false);
  again.play(std::move(*opened.replay));
  for (int i = 0; i < 20; ++i) again.step();
  CHECK(again.springs() == lived.springs());
  CHECK(again.state().displacement == lived.state().displacement);
  CHECK(again.state().velocity == lived.state().velocity);
}

TEST_CASE("tissue sleeps until a grab of its scene begins") {
  const Handled cube(
      R"([{"select": {"box": [[-1, 0.09, -1], [1, 1, 1]]}, "translate": [0.02, 0, 0], "start": 1.5, "duration": 0.2}])");
  Graphics graphics = open_graphics(headless(), false);
  Simulation simulation(cube.scene(), graphics.programs.get(), false);
  long slept = 0;
  while (simulation.time() < 1.49 - 1.0 / 60) {
    simulation.step();
    slept += simulation.asleep();
  }
  CHECK(slept > 10);
  CHECK(simulation.asleep());
  CHECK(simulation.awaits_inputs());  // so that a window continues
  for (int i = 0; i < 20; ++i) simulation.step();
  CHECK_FALSE(simulation.asleep());
  double largest = 0;
  for (const Vector3d& u : simulation.state().displacement) largest = std::max(largest, u.norm());
  CHECK(largest > 0.005);
  CHECK_FALSE(simulation.awaits_inputs());
}

TEST_CASE("run takes grabs on the command line and reports their forces") {
  const Handled cube("[]");
  const CommandResult result = run_fascia({"run", (cube.folder / "cube.json").string(), "--context", "osmesa",
                                           "--quiet", "--steps", "20", "--stats", (cube.folder / "stats.json").string(),
                                           "--grab", "at=0,0.1,0;translate=0.02,0,0;duration=0.2;radius=0.03"});
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  const std::string stats = read_file(cube.folder / "stats.json");
  CHECK(stats.find("\"grabs\": 0") != std::string::npos);
  CHECK(stats.find("\"imbalance\"") != std::string::npos);
  const CommandResult far =
      run_fascia({"run", (cube.folder / "cube.json").string(), "--context", "osmesa", "--grab", "at=9,9,9"});
  CHECK(far.exit_code == 1);
  CHECK(far.err.find("grabs[0].at: ") != std::string::npos);
}
