// A body at rest costs nothing until something changes, and lies where it would have come to rest without sleep.
// Covers: settling, simulation, simulation_checks
#include <catch2/catch.hpp>

#include "app/session/graphics.h"
#include "sim/material/tissue_looks.h"
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

// A soft box, fixed at one side, that sags under its weight.
struct RestingBox {
  TemporaryFolder folder;
  Graphics graphics = open_graphics(headless(), false);
  Scene scene;
  explicit RestingBox(double damping = 0.02) {
    write_mesh(folder / "box.msh", make_box(4, 2, 2, {0.2, 0.1, 0.1}));
    scene.file = folder / "box.json";
    Body body;
    body.name = "box";
    body.mesh = "box.msh";
    body.material.young_modulus = 3e4;
    body.material.damping = damping;
    body.fixed.push_back(BoxSelection{{-1e-6, -1, -1}, {1e-6, 1, 1}});
    scene.bodies.push_back(body);
  }
  std::unique_ptr<Simulation> open() { return std::make_unique<Simulation>(scene, graphics.programs.get(), false); }
};

constexpr long kMost = 3000;  // steps: 50 s

void step_until_asleep(Simulation& simulation) {
  for (long i = 0; i < kMost && !simulation.asleep(); ++i) simulation.step();
  REQUIRE(simulation.asleep());
}

}  // namespace

TEST_CASE("a body that has come to rest sleeps: no dispatch, the same bits, and time continues", "[sleep]") {
  RestingBox box;
  const auto simulation = box.open();
  step_until_asleep(*simulation);
  CAPTURE(simulation->steps_made());
  CHECK(simulation->steps_made() > 30);  // it had to fall first
  const State before = simulation->state();
  const std::uint64_t dispatches = gl::dispatch_count();
  const long asleep = simulation->steps_asleep(), made = simulation->steps_made();
  for (int i = 0; i < 100; ++i) simulation->step();
  CHECK(gl::dispatch_count() == dispatches);
  CHECK(simulation->steps_asleep() == asleep + 100);
  CHECK(simulation->steps_made() == made + 100);
  const State after = simulation->state();
  CHECK(after.displacement == before.displacement);
  CHECK(after.velocity == before.velocity);
  CHECK(after.time == Approx(before.time + 100 * box.scene.solver.time_step));
  CHECK_FALSE(simulation->check_now());
}

TEST_CASE("a sleeping body lies where one that never sleeps does", "[sleep]") {
  RestingBox box(GENERATE(0.0, 0.02));
  const auto sleeping = box.open();
  box.scene.solver.rest_speed = 0;
  const auto awake = box.open();
  const double size = awake->gpu()->buffers().size;
  double largest = 0, kick = 0;
  State before;
  for (int i = 0; i < 1500; ++i) {
    sleeping->step();
    awake->step();
    const State state = awake->state();
    largest = std::max(largest, farthest(sleeping->state(), state));
    if (i > 1000) kick = std::max(kick, farthest(before, state));
    before = state;
  }
  CAPTURE(largest / size, kick / size, sleeping->steps_asleep());
  CHECK(sleeping->asleep());
  CHECK_FALSE(awake->asleep());
  CHECK(awake->steps_asleep() == 0);
  CHECK(largest < 5e-6 * size);
  CHECK(kick < 1e-6 * size);  // from one step to the next, rounding only
}

// Between two checks an oscillation of 9 um stands still at its turning point: asleep there, the tip was 0.004 % of its
// displacement from the equilibrium.
TEST_CASE("a body falls asleep in its static equilibrium, not at the turning point of an oscillation", "[sleep]") {
  RestingBox box(0.05);
  write_mesh(box.folder / "beam.msh", make_box(24, 6, 6, {1, 0.25, 0.25}));
  box.scene.bodies[0].mesh = "beam.msh";
  box.scene.bodies[0].material.young_modulus = 1e6;
  const bool pulled = GENERATE(false, true);
  const auto simulation = box.open();
  if (pulled) simulation->set_grab({{1000, {0, 0.1, 0}, 50}});
  step_until_asleep(*simulation);
  State equilibrium = simulation->state();
  reference::NewtonSolver newton(simulation->model, box.scene.solver);
  newton.set_springs(simulation->springs());
  const reference::NewtonReport report = newton.solve_static(equilibrium);
  REQUIRE(report.converged);
  const double distance = farthest(simulation->gpu()->download(), equilibrium),
               size = simulation->gpu()->buffers().size;
  CAPTURE(pulled, simulation->steps_made(), distance, size);
  CHECK(distance < 9e-9 * size);  // a thousandth of the earlier distance, and the rounding of displacements to float32
  CHECK(farthest(simulation->state(), equilibrium) < 1e-11);
  for (const Vector3d& v : simulation->gpu()->download().velocity) REQUIRE(v == Vector3d::Zero());
}

TEST_CASE("a method whose fixed point is no equilibrium sleeps after a second at rest", "[sleep]") {
  RestingBox box;
  box.scene.solver.method = Method::mass_splitting;
  box.scene.solver.acceleration = Acceleration::none;
  const auto sleeping = box.open();
  step_until_asleep(*sleeping);
  const long asleep = sleeping->steps_made();
  const auto again = box.open();
  const SolverSettings& settings = box.scene.solver;
  const double h = settings.substep(), size = again->gpu()->buffers().size;
  while (again->steps_made() < asleep) {
    again->step();
    if (again->steps_made() < asleep - std::lround(1 / settings.time_step)) continue;
    const State state = again->state();
    double speed = 0, displacement = 0;
    for (const Vector3d& v : state.velocity) speed = std::max(speed, v.norm());
    for (const Vector3d& u : state.displacement) displacement = std::max(displacement, u.norm());
    CAPTURE(asleep, again->steps_made(), speed, displacement);
    REQUIRE(is_still(h * speed, h, displacement, settings, size));
  }
}

TEST_CASE("every change that affects a sleeping body wakes it, and no other", "[sleep]") {
  RestingBox box;
  const auto simulation = box.open();
  const GrabInput springs{{44, {0.01, 0, 0}, 200}};
  simulation->set_grab(springs);
  step_until_asleep(*simulation);
  simulation->set_grab(springs);
  CHECK(simulation->asleep());
  Material painted = simulation->model.materials[0];
  painted.look = &tissue_looks().back();
  painted.color = {0.1, 0.2, 0.3};
  simulation->set_material(0, painted);
  CHECK(simulation->asleep());
  CHECK(simulation->model.materials[0] == painted);
  const State held = simulation->state();

  const auto moves = [&] {
    CHECK_FALSE(simulation->asleep());
    const State before = simulation->state();
    for (int i = 0; i < 5; ++i) simulation->step();
    const double way = farthest(before, simulation->state());
    step_until_asleep(*simulation);
    return way;
  };
  simulation->set_grab({});
  CHECK(moves() > 1e-4);
  Material material = simulation->model.materials[0];
  material.young_modulus *= 2;
  simulation->set_material(0, material);
  CHECK(moves() > 1e-4);
  simulation->set_gravity({0, 9.81, 0});
  CHECK(moves() > 1e-4);
  SolverSettings settings = simulation->scene.solver;
  settings.iterations = 12;
  simulation->set_settings(settings);
  CHECK_FALSE(simulation->asleep());
  step_until_asleep(*simulation);
  simulation->reset();
  CHECK(moves() > 1e-4);
}

TEST_CASE("sleep begins at the same step in every run, and ends in the same bits", "[sleep]") {
  RestingBox box;
  long begins[2];
  State states[2];
  for (int run = 0; run < 2; ++run) {
    const auto simulation = box.open();
    for (int i = 0; i < 40; ++i) simulation->step();
    if (run == 1) simulation->state();  // a readback in between has no effect
    simulation->set_grab({{44, {0, 0.02, 0}, 300}});
    step_until_asleep(*simulation);
    begins[run] = simulation->steps_made();
    simulation->set_grab({});
    for (int i = 0; i < 50; ++i) simulation->step();
    states[run] = simulation->state();
  }
  CHECK(begins[0] == begins[1]);
  CHECK(states[0].displacement == states[1].displacement);
  CHECK(states[0].velocity == states[1].velocity);
}

TEST_CASE("nothing sleeps before a prescribed motion has ended", "[sleep]") {
  RestingBox box;
  PrescribedMotion motion;
  motion.select = BoxSelection{{0.2 - 1e-6, -1, -1}, {0.2 + 1e-6, 1, 1}};
  motion.translate = {0, 0.01, 0};
  motion.start = 20;
  motion.duration = 0.1;
  box.scene.bodies[0].prescribed.push_back(motion);
  const auto simulation = box.open();
  while (simulation->time() < 20.1) {
    simulation->step();
    REQUIRE_FALSE(simulation->asleep());
  }
  step_until_asleep(*simulation);
}

TEST_CASE("every method falls asleep, unless its iterations never stop moving the body", "[sleep]") {
  RestingBox box;
  const SolverChoice pair = GENERATE(from_range(solver_choices()));
  box.scene.solver.method = pair.method;
  box.scene.solver.acceleration = pair.acceleration;
  const auto simulation = box.open();
  CAPTURE(name_of(pair.method), name_of(pair.acceleration));
  for (long i = 0; i < kMost && !simulation->asleep() && !simulation->diverged(); ++i) simulation->step();
  CHECK_FALSE(simulation->diverged());
  if (simulation->asleep()) return;
  // Positions combined without their multipliers, and forces taken from the start of a step.
  CHECK((pair.acceleration == Acceleration::anderson_positions ||
         pair == SolverChoice{Method::exact_xpbd, Acceleration::none}));
  double speed = 0;
  for (int i = 0; i < 20; ++i) {
    simulation->step();
    for (const Vector3d& v : simulation->state().velocity) speed = std::max(speed, v.norm());
  }
  CHECK(speed > box.scene.solver.rest_speed * simulation->gpu()->buffers().size);
}
