// Two settings side by side: the same steps under the same grab, without any effect on the first side.
#include <catch2/catch.hpp>

#include "app/compare/split_view.h"
#include "app/session/graphics.h"
#include "base/file.h"
#include "sim/grab/build_model.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

// Jacobi carries it.
const std::string kModel = "materials.default.model=signed_st_venant_kirchhoff";

Scene cube() { return open_scene(source_dir() / "assets/scenes/cube.json", {kModel}); }

double largest_difference(const State& a, const State& b) {
  double largest = 0;
  for (std::size_t v = 0; v < a.displacement.size(); ++v)
    largest = std::max(largest, (a.displacement[v] - b.displacement[v]).norm());
  return largest;
}

/// Pulls a few free vertices up.
std::vector<GrabSpring> pull(const Model& model) {
  const std::vector<char> held = model.held();
  std::vector<GrabSpring> springs;
  for (std::uint32_t v = 0; v < held.size() && springs.size() < 4; ++v)
    if (!held[v]) springs.push_back({v, Eigen::Vector3d(0, 0.02, 0), 50});
  return springs;
}

}  // namespace

TEST_CASE("two sides with the same settings stay the same to the bit, and equal a single session", "[split]") {
  Graphics graphics = open_graphics(headless(), false);
  const Scene scene = cube();
  Session alone(graphics, scene, false), a(graphics, scene, false);
  for (int i = 0; i < 2; ++i) {
    alone.simulation.step();
    a.simulation.step();
  }
  SplitView split(graphics, a, scene, a.simulation.model);
  CHECK(split.b().simulation.time() == a.simulation.time());
  const std::vector<GrabSpring> springs = pull(a.simulation.model);
  alone.simulation.set_grab(springs);
  a.simulation.set_grab(springs);
  for (int i = 0; i < 5; ++i) {
    alone.simulation.step();
    split.step(a, a);
  }
  CHECK(split.b().simulation.gpu()->springs() == springs);
  CHECK(largest_difference(a.simulation.state(), split.b().simulation.state()) == 0);
  CHECK(largest_difference(a.simulation.state(), alone.simulation.state()) == 0);

  INFO("the grab may be at the other side");
  split.b().simulation.set_grab({});
  split.step(a, split.b());
  CHECK(a.simulation.gpu()->springs().empty());
}

TEST_CASE("sides differ in their settings, and share display, gravity and time step", "[split]") {
  Graphics graphics = open_graphics(headless(), false);
  Session a(graphics, cube(), false);
  Scene other = cube();
  other.solver.method = Method::jacobi;
  other.solver.acceleration = Acceleration::none;
  other.bodies[0].material.young_modulus *= 10;
  other.solver.time_step = 0.5;
  other.gravity = {1, 2, 3};
  Model model = build_model(other);
  SplitView split(graphics, a, other, model);
  CHECK(split.b().simulation.scene.solver.method == Method::jacobi);
  CHECK(split.b().simulation.scene.solver.time_step == a.simulation.scene.solver.time_step);
  CHECK(split.b().simulation.scene.gravity == a.simulation.scene.gravity);
  for (int i = 0; i < 3; ++i) split.step(a, a);
  CHECK(largest_difference(a.simulation.state(), split.b().simulation.state()) > 1e-5);
  CHECK(a.simulation.time() == Approx(split.b().simulation.time()));

  split.b().simulation.set_gravity({0, 5, 0});
  DisplaySettings display = split.b().display();
  display.wireframe = !display.wireframe;
  split.b().set_display(display);
  split.share(a);
  CHECK(a.simulation.scene.gravity == Eigen::Vector3d(0, 5, 0));
  CHECK(a.display() == display);

  const auto before_a = a.simulation.state();
  auto session = std::make_unique<Session>(graphics, cube(), false);
  session->simulation.go_on_from(before_a);
  SplitView again(graphics, *session, other, model);
  again.swap(session);
  CHECK(session->simulation.scene.solver.method == Method::jacobi);
  CHECK(again.b().simulation.scene.solver.method == cube().solver.method);
}

TEST_CASE("a replay's inputs to one side apply to the other, except where they differ", "[split]") {
  Graphics graphics = open_graphics(headless(), false);
  Session a(graphics, cube(), false);
  Replay replay{cube(), std::nullopt, {}, 16};
  Material soft = a.simulation.model.materials[0];
  soft.young_modulus /= 2;
  SolverSettings slower = cube().solver;
  slower.time_step *= 0.5;
  replay.inputs = {{1, GrabInput(pull(a.simulation.model))},
                   {3, MaterialInput{0, soft}},
                   {4, GravityInput{{1, 2, 3}}},
                   {5, slower},
                   {8, ResetInput{}},
                   {9, GrabInput{}},
                   {16, ResetInput{}}};
  a.simulation.play(replay);
  Scene other = cube();
  const bool differs = GENERATE(false, true);
  if (differs) other.solver.iterations = 3;
  SplitView split(graphics, a, other, build_model(other));
  for (int i = 0; i < 24; ++i) {
    if (i == 16) split.reset(a);  // and again from the beginning
    split.step(a, a);
    CAPTURE(i);
    const Simulation& b = split.b().simulation;
    CHECK(b.time() == a.simulation.time());
    CHECK(b.scene.gravity == a.simulation.scene.gravity);
    CHECK(b.scene.solver.time_step == a.simulation.scene.solver.time_step);
    CHECK(b.model.materials == a.simulation.model.materials);
    if (differs) CHECK(b.scene.solver.iterations == 3);
    if (!differs) CHECK(largest_difference(a.simulation.state(), b.state()) == 0);
  }
  CHECK(a.simulation.model.materials[0] == soft);

  INFO("reset() leads both to where A starts");
  replay.start = a.simulation.state();
  replay.start->displacement.back() += Eigen::Vector3d(0.01, 0, 0);
  a.simulation.play(replay);
  a.simulation.end_replay();
  split.restart_from(a);
  split.step(a, a);
  split.reset(a);
  CHECK(largest_difference(a.simulation.state(), split.b().simulation.state()) == 0);
  CHECK(largest_difference(a.simulation.state(), initial_state(a.simulation.model)) > 0.009);
}

TEST_CASE("a replay controls both sides wherever the mouse is, and a release on one side applies to both", "[split]") {
  Graphics graphics = open_graphics(headless(), false);
  Replay replay{cube(), std::nullopt, {}, 8};
  const std::vector<GrabSpring> springs = pull(build_model(cube()));
  const auto moved = [&](std::size_t count, double x) { return GrabMove{{{count, Eigen::Vector3d(x, 0, 0)}}}; };
  replay.inputs = {{0, springs},
                   {1, moved(4, 0.001)},
                   {3, GrabInput{}},
                   {4, GrabInput{springs.begin(), springs.begin() + 2}},
                   {6, moved(2, 0.002)}};
  Session alone(graphics, cube(), false), a(graphics, cube(), false);
  alone.simulation.play(replay);
  a.simulation.play(replay);
  SplitView split(graphics, a, cube(), a.simulation.model);
  for (int i = 0; i < 8; ++i) {
    alone.simulation.step();
    split.step(a, split.b());  // pressed on B's side, for an orbit
    CHECK(a.simulation.asked_springs() == alone.simulation.asked_springs());
  }
  CHECK(largest_difference(a.simulation.state(), alone.simulation.state()) == 0);

  a.simulation.end_replay();
  split.lead(a, a);
  CHECK(split.b().simulation.asked_springs().size() == 2);
  split.b().simulation.set_grab({});
  split.lead(a, split.b());
  CHECK(a.simulation.asked_springs().empty());
}

TEST_CASE("the second side starts in the state of the first", "[split]") {
  Graphics graphics = open_graphics(headless(), false);
  auto a = std::make_unique<Session>(graphics, cube(), false);
  for (int i = 0; i < 3; ++i) a->simulation.step();
  const State start = a->simulation.state();
  a->simulation.play({cube(), start, {}, 5});
  for (int i = 0; i < 2; ++i) a->simulation.step();
  SplitView split(graphics, *a, cube(), a->simulation.model);
  split.swap(a);
  a->simulation.reset();
  CHECK(largest_difference(a->simulation.state(), start) == 0);
  CHECK(a->simulation.time() == start.time);
}

TEST_CASE("a side with another mesh is refused", "[split]") {
  Graphics graphics = open_graphics(headless(), false);
  Session a(graphics, cube(), false);
  const Scene beam = open_scene(source_dir() / "assets/scenes/beam.json");
  CHECK_THROWS_WITH(SplitView(graphics, a, beam, build_model(beam)), Catch::Contains("another mesh"));
}

TEST_CASE("render --split draws each side as it is drawn alone", "[split]") {
  const TemporaryFolder folder;
  const std::string scene = (source_dir() / "assets/scenes/cube.json").string();
  const auto render = [&](const std::string& name, const std::string& size, std::vector<std::string> more) {
    std::vector<std::string> arguments = {"render",
                                          scene,
                                          "--steps",
                                          "10",
                                          "--size",
                                          size,
                                          "--samples",
                                          "1",
                                          "--context",
                                          "osmesa",
                                          "--quiet",
                                          "--set",
                                          "display.ground=false",  // below the lower side, in both
                                          "--set",
                                          kModel,
                                          "--out",
                                          (folder / name).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const CommandResult result = run_fascia(arguments);
    CAPTURE(result.err);
    REQUIRE(result.exit_code == 0);
    return read_png(folder / name);
  };
  const std::string b = "solver.method=jacobi;solver.acceleration=none;materials.default.young_modulus=1e3";
  // Two pixels of divider: the sides are as wide as the pictures alone. Labels are at their upper and lower ends.
  const Image both = render("both.png", "402x300", {"--split", b});
  const Image left = render("a.png", "200x300", {});
  const Image right = render("b.png", "200x300",
                             {"--set", "solver.method=jacobi", "--set", "solver.acceleration=none", "--set",
                              "materials.default.young_modulus=1e3"});
  const auto middle = [](const Image& image, int x) {
    Image part{200, 100, {}};
    for (int y = 120; y < 220; ++y) {
      const auto row = image.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * image.width + x);
      part.rgba.insert(part.rgba.end(), row, row + 800);
    }
    return part;
  };
  CHECK(difference(middle(both, 0), middle(left, 0)).share == 0);
  CHECK(difference(middle(both, 202), middle(right, 0)).share == 0);
  CHECK(difference(middle(left, 0), middle(right, 0)).share > 0.01);
  const CommandResult shared =
      run_fascia({"render", scene, "--split", "gravity=[0,0,0]", "--out", (folder / "x.png").string()});
  CHECK(shared.exit_code == 1);
  CHECK_THAT(shared.err, Catch::Contains("which both sides share"));
  CHECK(
      run_fascia({"render", scene, "--split", "solver.methd=jacobi", "--out", (folder / "x.png").string()}).exit_code ==
      2);
}
