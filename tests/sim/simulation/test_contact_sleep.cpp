// Tissue that lies on something falls asleep there, with the forces that hold it, and wakes when something touches it.
// Covers: simulation, simulation_checks
#include <catch2/catch.hpp>

#include "app/session/graphics.h"
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

constexpr double kSize = 0.2, kWeight = 78.48;  // [m], [N] at 1,000 kg/m^3
constexpr long kLongest = 600;                  // steps: 10 s

// A cube that is set down on a table, a ball beside it, and jaws far away.
struct LaidCube {
  TemporaryFolder folder;
  Graphics graphics = open_graphics(headless(), false);
  Scene scene;
  LaidCube() {
    write_mesh(folder / "cube.msh", make_box(4, 4, 4, {kSize, kSize, kSize}));
    scene.file = folder / "cube.json";
    Body body;
    body.name = "cube";
    body.mesh = (folder / "cube.msh").string();
    body.material.young_modulus = 1e5;
    body.material.damping = 0.05;
    scene.bodies.push_back(body);
    scene.tools.ground = Ground{-0.001, 0.5};
    scene.tools.instruments.push_back(
        {"ball", ToolShape(SphereShape{{0, 0, 0}, 0.04}), std::nullopt, {{0, {0.1, 0.5, 0.1}, {0, 0, 0}, 0}}, false});
  }
  std::unique_ptr<Simulation> open() const {
    return std::make_unique<Simulation>(scene, graphics.programs.get(), false);
  }
};

void lie_down(Simulation& simulation) {
  for (long i = 0; i < kLongest && !simulation.asleep(); ++i) simulation.step();
  REQUIRE(simulation.asleep());
}

double push_of_ground(Simulation& simulation) {
  simulation.gpu()->request_diagnostics();
  return simulation.gpu()->take_diagnostics(true)->tool_loads.at(0).force.y();
}

LedTool ball_at(const Vector3d& place) { return {"ball", {place, {0, 0, 0}, 0}}; }

}  // namespace

TEST_CASE("a cube set down on the ground sleeps there: no dispatch, the same bits, its weight read out", "[sleep]") {
  const LaidCube laid;
  const auto simulation = laid.open();
  lie_down(*simulation);
  CAPTURE(simulation->time());
  CHECK(simulation->time() > 1);  // at rest for a second
  const State before = simulation->state();
  const std::uint64_t dispatches = gl::dispatch_count();
  for (int i = 0; i < 100; ++i) simulation->step();
  CHECK(gl::dispatch_count() == dispatches);
  CHECK(simulation->steps_asleep() == 100);
  State after = simulation->state();
  CHECK(after.time == Approx(before.time + 100.0 / 60));
  after.time = before.time;
  CHECK(state_hash(after) == state_hash(before));
  CHECK(after.contact == before.contact);
  CHECK(std::any_of(after.contact.begin(), after.contact.end(), [](const ContactForce& f) { return f.normal > 0; }));
  CHECK(push_of_ground(*simulation) == Approx(kWeight).epsilon(1e-4));
  simulation->set_gravity({0, -9.81, 0});  // the same: it goes on with the forces that it has
  CHECK_FALSE(simulation->asleep());
  simulation->step();
  CHECK(push_of_ground(*simulation) == Approx(kWeight).epsilon(1e-4));
  CHECK(farthest(simulation->state(), before) < 1e-7 * kSize);
}

TEST_CASE("a poke wakes a sleeping cube, which then moves as one that never slept", "[sleep]") {
  LaidCube laid;
  laid.scene.tools.instruments[0].path = {{0, {0.1, 0.9, 0.1}, {0, 0, 0}, 0},     // moves afar all the time
                                          {4, {0.1, 0.5, 0.1}, {0, 0, 0}, 0},     //
                                          {5, {0.08, 0.21, 0.1}, {0, 0, 0}, 0},   // 3 cm deep
                                          {5.5, {0.1, 0.21, 0.1}, {0, 0, 0}, 0},  // to the side
                                          {6, {0.1, 0.5, 0.1}, {0, 0, 0}, 0}};
  laid.scene.solver.iterations = 20;  // of ten, the error while the ball slides is larger than what sleep changes
  const auto sleeping = laid.open();
  laid.scene.solver.rest_speed = 0;
  const auto awake = laid.open();
  double before = 0, largest = 0, poked = 0;
  long slept = 0;
  while (sleeping->time() < 7) {
    sleeping->step();
    awake->step();
    const State exact = awake->state();
    const double difference = farthest(sleeping->state(), exact);
    largest = std::max(largest, difference);
    if (sleeping->asleep()) {
      before = difference;
      slept = sleeping->steps_made();
      CHECK(sleeping->time() < 5);
    }
    if (std::abs(sleeping->time() - 5) < 0.01) poked = farthest(initial_state(sleeping->model), exact);
  }
  CAPTURE(before / kSize, largest / kSize, slept, poked, sleeping->steps_asleep());
  CHECK(sleeping->steps_asleep() > 60);
  CHECK(slept > 4 * 60);  // while the ball came from afar
  CHECK(poked > 0.02);
  CHECK(awake->steps_asleep() == 0);
  CHECK(before < 1e-6 * kSize);
  // Friction goes on to settle in the cube that is awake, and the poke slides.
  CHECK(largest < 1e-4 * poked);
}

TEST_CASE("what may touch a sleeping cube or changes its forces wakes it; what is far away does not", "[sleep]") {
  LaidCube laid;
  const auto simulation = laid.open();
  const auto far_ball = [](double x) { return ball_at({0.1 + x, 0.5, 0.1}); };
  for (long i = 0; i < kLongest && !simulation->asleep(); ++i) {
    simulation->lead(far_ball(1e-3 * static_cast<double>(i % 2)));  // a hand that is never still
    simulation->step();
  }
  REQUIRE(simulation->asleep());
  for (int i = 0; i < 30; ++i) {
    simulation->lead(far_ball(0.01 * (i + 1)));
    simulation->step();
    REQUIRE(simulation->asleep());
    REQUIRE(simulation->awaits_inputs());  // a window goes on drawing
  }
  simulation->step();
  CHECK_FALSE(simulation->awaits_inputs());
  simulation->lead(ball_at({0.1, 0.25, 0.1}));  // 1 cm from the top
  simulation->step();
  CHECK_FALSE(simulation->asleep());
  lie_down(*simulation);
  simulation->lead(ball_at({0.1, 0.25, 0.1}));  // where it is
  simulation->step();
  CHECK(simulation->asleep());
  simulation->lead(ball_at({0.1, 0.22, 0.1}));
  simulation->step();
  CHECK_FALSE(simulation->asleep());
  lie_down(*simulation);  // pressed
  CHECK(push_of_ground(*simulation) > 1.1 * kWeight);
  simulation->lead(ball_at({0.1, 0.221, 0.1}));  // moves while it touches
  simulation->step();
  CHECK_FALSE(simulation->asleep());
  lie_down(*simulation);
  simulation->set_grab({{60, {0, 0.02, 0}, 200}});
  CHECK_FALSE(simulation->asleep());
  simulation->set_grab({});
  lie_down(*simulation);
  Material material = simulation->model.materials[0];
  material.young_modulus *= 1.1;
  simulation->set_material(0, material);
  CHECK_FALSE(simulation->asleep());
  lie_down(*simulation);
  simulation->set_gravity({1, -9.81, 0});
  CHECK_FALSE(simulation->asleep());
  lie_down(*simulation);
}

TEST_CASE("a session whose tissue sleeps in contact and is woken by a hand is replayed to the bit", "[sleep]") {
  const LaidCube laid;
  const auto simulation = laid.open();
  Replay replay{simulation->scene, std::nullopt, {}, 0};
  simulation->set_listener([&](const Input& input) { replay.inputs.push_back(input); });
  lie_down(*simulation);
  for (int i = 0; i < 60; ++i) {
    simulation->lead(ball_at({0.1, 0.5 - 0.005 * i, 0.1}));
    simulation->step();
  }
  CHECK_FALSE(simulation->asleep());
  CHECK(push_of_ground(*simulation) > 1.2 * kWeight);
  replay.steps = simulation->steps_made();
  const auto again = laid.open();
  again->play(replay);
  while (again->replaying()) again->step();
  CHECK(again->steps_asleep() == simulation->steps_asleep());
  CHECK(state_hash(again->state()) == state_hash(simulation->state()));
  CHECK(again->state().contact == simulation->state().contact);
}
