// Divergence: commands end with one line and a file that reproduces it.
// Covers: simulation_replay
#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

#include "app/session/graphics.h"
#include "app/session/open_input.h"
#include "app/stress/stress.h"
#include "base/error.h"
#include "sim/grab/build_model.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/reference/elasticity.h"
#include "sim/simulation/divergence.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

constexpr std::uint32_t kLost = 17;  // of the box's vertices, a free one

// A clamped box of 48 tets in its own folder, and a replay whose start has one vertex so far away that its forces
// overflow.
struct Box {
  TemporaryFolder folder;
  Scene scene;
  Box() {
    write_mesh(folder / "box.msh", make_box(2, 2, 2, {0.2, 0.2, 0.2}));
    scene.file = folder / "box.json";
    Body body;
    body.name = "box";
    body.mesh = "box.msh";
    body.fixed.push_back(BoxSelection{{-1e-6, -1, -1}, {1e-6, 1, 1}});
    scene.bodies.push_back(body);
  }
  Replay broken() const {
    Replay replay{scene, initial_state(build_model(scene)), {}, 30};
    replay.start->displacement[kLost] = {1e25, 0, 0};
    return replay;
  }
};

}  // namespace

TEST_CASE("run ends with one line, exit code 1 and a replay with the same end") {
  const Box box;
  write_replay(box.folder / "broken.fascia", box.broken());
  std::string replay = "broken.fascia";
  for (int time = 0; time < 2; ++time) {
    const CommandResult run =
        run_fascia({"run", "--replay", replay, "--context", "osmesa", "--export", "out.vtu"}, box.folder.path());
    CAPTURE(run.out, run.err);
    CHECK(run.exit_code == 1);
    CHECK_FALSE(std::filesystem::exists(box.folder / "out.vtu"));
    const std::size_t begin = run.err.find("diverged at "), named = run.err.find("repeated by ");
    REQUIRE(begin != std::string::npos);
    REQUIRE(named != std::string::npos);
    replay = run.err.substr(named + 12, run.err.find(';', named) - named - 12);
    CHECK(std::filesystem::exists(box.folder / replay));
    // The named tet has the diverged vertex.
    const std::size_t list = run.err.find("vertices ") + 9;
    std::istringstream vertices(run.err.substr(list, run.err.find(',', list) - list));
    bool has = false;
    for (std::uint32_t v; vertices >> v;) has |= v == kLost;
    CHECK(has);
  }
}

TEST_CASE("a divergence in contact names the tool") {
  Box box;
  box.scene.tools.obstacles.push_back({"rock", SphereShape{{0.1, 0.45, 0.1}, 0.25}, {0, 0, 0}, {0, 0, 0}, {}});
  write_replay(box.folder / "broken.fascia", box.broken());
  const CommandResult run = run_fascia({"run", "--replay", "broken.fascia", "--context", "osmesa"}, box.folder.path());
  CAPTURE(run.err);
  CHECK(run.exit_code == 1);
  CHECK_THAT(run.err, Catch::Contains(" s in contact with rock, repeated by "));
}

TEST_CASE("render ends in the same manner and writes no picture") {
  const Box box;
  write_replay(box.folder / "broken.fascia", box.broken());
  const CommandResult run =
      run_fascia({"render", "--replay", "broken.fascia", "--context", "osmesa", "--out", "out.png", "--size", "64x64"},
                 box.folder.path());
  CAPTURE(run.err);
  CHECK(run.exit_code == 1);
  CHECK(run.err.find("diverged at ") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(box.folder / "out.png"));
}

TEST_CASE("a replay repeats a session of sliders and grabs to the bit") {
  const Box box;
  Graphics graphics = open_graphics(headless(), false);
  Simulation lived(box.scene, graphics.programs.get(), false);
  std::vector<State> states;
  const auto live = [&](int steps) {
    for (int i = 0; i < steps; ++i) {
      lived.gpu()->finish_background();  // as in the replay, where the coarse level follows a slider
      lived.step();
    }
    states.push_back(lived.state());
  };
  Replay replay{box.scene, std::nullopt, {}, 12};
  const auto both = [&](Input input) {
    input.step = lived.steps_made();
    replay.inputs.push_back(input);
    if (auto* settings = std::get_if<SolverSettings>(&input.change)) lived.set_settings(*settings);
    if (auto* material = std::get_if<MaterialInput>(&input.change))
      lived.set_material(material->index, material->material);
    if (auto* gravity = std::get_if<GravityInput>(&input.change)) lived.set_gravity(gravity->gravity);
    if (auto* springs = std::get_if<GrabInput>(&input.change)) lived.set_grab(*springs);
  };
  both({0, GrabInput{{kLost, {0.05, 0.02, 0}, 300}}});
  live(3);
  Material soft = lived.model.materials[0];
  soft.young_modulus = 3e4;
  both({0, MaterialInput{0, soft}});
  live(3);
  SolverSettings other = lived.scene.solver;
  other.method = Method::vertex_descent;
  other.acceleration = Acceleration::anderson;
  both({0, other});
  both({0, GravityInput{{1, 2, 3}}});
  live(3);
  both({0, GrabInput{}});
  live(3);

  write_replay(box.folder / "lived.fascia", replay);
  Opened opened = open_file(box.folder / "lived.fascia");
  REQUIRE(opened.replay);
  Simulation again(std::move(opened.scene), graphics.programs.get(), false);
  again.play(std::move(*opened.replay));
  for (std::size_t part = 0; part < states.size(); ++part) {
    for (int i = 0; i < 3; ++i) again.step();
    CAPTURE(part);
    CHECK(again.state().displacement == states[part].displacement);
    CHECK(again.state().velocity == states[part].velocity);
  }
}

TEST_CASE("a diverged state returns to the last valid one, and its replay begins there") {
  const Box box;
  Graphics graphics = open_graphics(headless(), false);
  Simulation simulation(box.scene, graphics.programs.get(), false);
  for (int i = 0; i < 20; ++i) simulation.step();
  REQUIRE_FALSE(simulation.check_now());
  const State sound = simulation.state();
  // Farther than floats can represent, beyond the range of any grab.
  simulation.set_grab({{kLost, {1e25, 0, 0}, 1e20}});
  for (int i = 0; i < 40 && !simulation.diverged(); ++i) simulation.step();
  REQUIRE(simulation.diverged());
  const Divergence divergence = find_divergence(simulation, *simulation.diverged());
  INFO(divergence.text(simulation.model));
  CHECK(divergence.found);
  CHECK(divergence.replay.steps >= 1);
  CHECK(divergence.replay.start->displacement == sound.displacement);
  CHECK(divergence.replay.start->velocity == sound.velocity);
  REQUIRE(divergence.replay.inputs.size() == 1);
  CHECK(std::get<GrabInput>(divergence.replay.inputs[0].change).size() == 1);
  CHECK_FALSE(simulation.diverged());
  const State back = simulation.state();
  CHECK(back.displacement == sound.displacement);
  CHECK(back.velocity == std::vector<Vector3d>(back.velocity.size(), Vector3d::Zero()));
  simulation.set_grab({});
  for (int i = 0; i < 20; ++i) simulation.step();
  CHECK_FALSE(simulation.check_now());
}

TEST_CASE("a replay that is cut within a divergence reports it") {
  const Box box;
  Replay replay = box.broken();
  replay.inputs.push_back({replay.steps - 1, RestoreInput{}});  // by which the state would be restored
  write_replay(box.folder / "led_back.fascia", replay);
  const CommandResult run = run_fascia(
      {"run", "--replay", "led_back.fascia", "--context", "osmesa", "--steps", std::to_string(replay.steps - 1)},
      box.folder.path());
  CAPTURE(run.err);
  CHECK(run.exit_code == 1);
  CHECK_THAT(run.err,
             Catch::Contains("diverged at ") && Catch::Contains("the replay goes back to a valid state later"));
}

TEST_CASE("a divergence beside a body at rest is reproduced with the same regions at rest") {
  Graphics graphics = open_graphics(headless(), false);
  Scene scene;
  scene.file = "bars.json";
  Model model = two_bars(24, 0.6, {2e6, 0.4, 1000, 0.1, MaterialModel::st_venant_kirchhoff});
  model.gravity.setZero();
  scene.gravity.setZero();
  std::uint32_t tip = 0;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if ((model.rest_positions[v] - Vector3d(0.6, 0.05, 0.05)).norm() <
        (model.rest_positions[tip] - Vector3d(0.6, 0.05, 0.05)).norm())
      tip = v;
  Simulation lived(scene, model, graphics.programs.get(), false);
  std::map<long, State> states;  // by number of steps
  constexpr long kTorn = 61;
  for (long step = 0; !lived.diverged() && step < kTorn + 40; ++step) {
    if (step <= kTorn)
      lived.set_grab({{tip,
                       {0, step < kTorn ? 0.05 * std::sin(0.2 * static_cast<double>(step)) : 1e25, 0},
                       step < kTorn ? 500.0 : 1e20}});
    lived.gpu()->finish_background();
    lived.step();
    states.emplace(lived.steps_made(), lived.gpu()->download());
  }
  REQUIRE(lived.diverged());
  CHECK(lived.gpu()->share_solved() < 0.8);  // the other bar rested
  const Divergence divergence = find_divergence(lived, *lived.diverged());
  REQUIRE(divergence.found);
  const long step = std::lround(divergence.time / scene.solver.time_step);
  CHECK(step == kTorn + 1);
  Corners rest, u;
  for (std::size_t a = 0; a < 4; ++a) {
    const std::uint32_t v = model.tets[divergence.tet][a];
    rest[a] = model.rest_positions[v];
    u[a] = states.at(step - 1).displacement[v];
  }
  CHECK(divergence.strain == reference::green_strain_matrix(LinearTet(rest), u).norm());  // to the bit
}

TEST_CASE("a replay that does not fit its mesh is refused") {
  const Box box;
  Graphics graphics = open_graphics(headless(), false);
  const auto error = [&](Replay replay) -> std::string {
    Simulation simulation(box.scene, graphics.programs.get(), false);
    try {
      simulation.play(std::move(replay));
    } catch (const Error& e) {
      return std::string(e.what()).substr(std::string(e.what()).find("box.json"));
    }
    return "";
  };
  Replay replay{box.scene, State{{{0, 0, 0}}, {{0, 0, 0}}, 0}, {}, 1};
  CHECK(error(replay) == "box.json: start has 1 vertices; expected the mesh's 27");
  replay.start.reset();
  replay.inputs = {{0, MaterialInput{3, {}}}};
  CHECK(error(replay) == "box.json: an input changes material 3; expected an index below 1");
  replay.inputs = {{0, GrabInput{{27, {0, 0, 0}, 1}}}};
  CHECK(error(replay) == "box.json: an input grabs vertex 27; expected an index below 27");
}
