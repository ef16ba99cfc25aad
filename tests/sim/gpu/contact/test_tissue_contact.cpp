// Tissue that meets tissue, and bodies that land, on the GPU against the reference, step by step from the same states.
// Covers: pair_stage
#include <catch2/catch.hpp>

#include "sim/contact/pair_search.h"
#include "sim/gpu/solver.h"
#include "sim/reference/newton.h"
#include "tests/sim/gpu/contact/contact_scenes.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/touching_bodies.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using test::cube;
using test::farthest;
using test::soft_tissue;
using test::squared;
using test::tool;
using test::two_level;

Model two_cubes(const Vector3d& closing) {
  const Model first =
      test::make_model(make_box(3, 3, 3, {0.2, 0.2, 0.2}), soft_tissue(1e5), [](const Vector3d&) { return false; });
  const Model second =
      test::make_model(make_box(4, 4, 4, {0.2, 0.2, 0.2}), soft_tissue(1e5), [](const Vector3d&) { return false; });
  Model model = test::beside(first, test::moved(second, {0.21, 0.03, 0.02}, -closing), "second");
  model.gravity.setZero();
  model.contact.friction = 0.3;
  return model;
}

// Root mean square over the steps in which something presses of the largest distance to the exact step from the same
// state, relative to the way of the step.
double error_of_steps(GpuSolver& solver, const Model& model, const SolverSettings& settings, int steps) {
  reference::NewtonSolver exact(model, settings);
  double squared = 0;
  int touching = 0;
  for (int i = 0; i < steps; ++i) {
    const State before = solver.download();
    State reference = before;
    exact.step(reference);
    solver.step();
    const auto& tools = exact.tool_loads();
    if (exact.pair_loads().empty() && std::none_of(tools.begin(), tools.end(), [](auto& t) { return t.points > 0; }))
      continue;
    const double share = farthest(solver.download(), reference) / farthest(reference, before);
    squared += share * share;
    ++touching;
  }
  REQUIRE(touching >= 3);
  return std::sqrt(squared / touching);
}

SolverSettings awake(int iterations) {
  SolverSettings settings = two_level(iterations);
  settings.rest_speed = 0;
  return settings;
}

TEST_CASE("bodies collide on the GPU as in the reference, step by step from the same states", "[gpu][contact]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  test::Gpu gpu(loads);
  const auto [iterations, largest_error] = GENERATE(std::pair(10, 0.02), std::pair(20, 0.005));
  const Model model = two_cubes({1, 0, 0});
  GpuSolver solver(gpu.programs, model, awake(iterations));
  const double error = error_of_steps(solver, model, awake(iterations), 12);
  Vector3d momentum(0, 0, 0);
  const State state = solver.download();
  const std::vector<double> masses = consistent_masses(model);
  for (std::size_t v = 0; v < masses.size(); ++v) momentum += masses[v] * state.velocity[v];
  CAPTURE(iterations, error, momentum.transpose());
  CHECK(error < largest_error);
  CHECK((momentum - Vector3d(-8, 0, 0)).norm() < 1e-5 * 8);
}

// They touch at the start, where the skin between them should be. With steps that part them by a quarter of the skin
// they left each other with 10 to 38 skins a second.
TEST_CASE("bodies that begin nearer than the skin part slowly", "[gpu][contact]") {
  test::Gpu gpu;
  SolverSettings settings = awake(10);
  settings.integrator = GENERATE(Integrator::implicit_euler, Integrator::bdf2, Integrator::sdirk2);
  Model model = two_cubes(Vector3d::Zero());
  for (std::uint32_t v = 64; v < model.rest_positions.size(); ++v) model.rest_positions[v].x() -= 0.01;
  const double skin = PairSearch(model).skin();
  GpuSolver solver(gpu.programs, model, settings);
  for (int i = 0; i < 60; ++i) solver.step();
  const State state = solver.download();
  double left = -1, right = 1, speed = 0;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v) {
    const double x = model.rest_positions[v].x() + state.displacement[v].x();
    if (v < 64) left = std::max(left, x);
    if (v >= 64) right = std::min(right, x);
    speed = std::max(speed, std::abs(state.velocity[v].x()));
  }
  CAPTURE(name_of(settings.integrator), skin, right - left, speed / skin);
  CHECK(right - left > 0.5 * skin);
  CHECK(speed < 4 * skin);
}

// Pairs that part slowly after a hit are pressed in further by what follows: 4 to 5 % of the energy were missing so.
TEST_CASE("a heavy body that hits a soft one has the energy of exact steps", "[gpu][contact]") {
  test::Gpu gpu;
  Material light = soft_tissue(5e4), heavy = soft_tissue(5e4);
  light.damping = heavy.damping = 0.01;
  heavy.density = 5000;
  const Model slab =
      test::make_model(make_box(8, 3, 3, {0.3, 0.06, 0.1}), light, [](const Vector3d& x) { return x.x() < 1e-9; });
  const Model cube =
      test::make_model(make_box(4, 4, 4, {0.08, 0.08, 0.08}), heavy, [](const Vector3d&) { return false; });
  Model model = test::beside(slab, test::moved(cube, {0.1, 0.1, 0.013}, {0, -3, 0}), "cube");
  model.contact.thickness = 0.0015;
  SolverSettings settings = awake(20);
  settings.integrator = Integrator::bdf2;
  settings.time_step = 0.01;
  GpuSolver solver(gpu.programs, model, settings);
  reference::NewtonSolver exact(model, settings);
  State reference = initial_state(model);
  for (int i = 0; i < 12; ++i) {
    solver.step();
    exact.step(reference);
    const double kinetic = reference::measure(model, solver.download()).kinetic,
                 expected = reference::measure(model, reference).kinetic;
    CAPTURE(i, kinetic, expected);
    CHECK(kinetic == Approx(expected).epsilon(0.02));
  }
}

// A heavy cube falls on a hanging beam with an edge first, and what it meets on its way is solved again after bodies
// were moved as wholes. 20 to 40 % of the energy were missing where that solve moved nothing. In other such hits ten
// iterations have up to 5 % too much.
TEST_CASE("a heavy body that falls on a hanging one has the energy of exact steps", "[gpu][contact]") {
  test::Gpu gpu;
  const auto [cells, turn] = GENERATE(std::pair(2, 0.3), std::pair(3, 0.7));
  Material light = squared(5e4), heavy = squared(5e4);
  light.poisson_ratio = heavy.poisson_ratio = 0.4;
  light.damping = heavy.damping = 0.01;
  heavy.density = 8000;
  const Model beam =
      test::make_model(make_box(6, 2, 2, {0.3, 0.06, 0.06}), light, [](const Vector3d& x) { return x.x() < 1e-9; });
  Model cube =
      test::make_model(make_box(cells, cells, cells, {0.1, 0.1, 0.1}), heavy, [](const Vector3d&) { return false; });
  const Eigen::Matrix3d turned(Eigen::AngleAxisd(turn, Vector3d(0.4, 1, 0.2).normalized()));
  for (Vector3d& x : cube.rest_positions) x = turned * (x - Vector3d(0.05, 0.05, 0.05)) + Vector3d(0.12, 0.16, 0.03);
  cube.file_mesh.positions = cube.rest_positions;
  Model model = test::beside(beam, test::moved(cube, {0, 0, 0}, {0, -2, 0}), "cube");
  model.gravity = {0, -9.81, 0};
  model.contact.friction = 0.2;
  SolverSettings settings = awake(10);
  settings.integrator = Integrator::bdf2;
  settings.time_step = 0.01;
  GpuSolver solver(gpu.programs, model, settings);
  reference::NewtonSolver exact(model, settings);
  State reference = initial_state(model);
  for (int i = 0; i < 8; ++i) {
    solver.step();
    exact.step(reference);
    const double kinetic = reference::measure(model, solver.download()).kinetic,
                 expected = reference::measure(model, reference).kinetic;
    CAPTURE(cells, turn, i, kinetic, expected);
    CHECK(kinetic == Approx(expected).epsilon(0.05));
  }
}

// It lands on an edge and tips: what presses changes in every step. Of 18 starts like this one ten iterations are 4 to
// 11 % of the way of a step off, in the mean 7.5 %. With 20 iterations this one is 0.5 %, and was once 1.1 % on an
// H100, whose other rounding lets other points touch first.
TEST_CASE("a cube lands on a slope as in the reference", "[gpu][contact]") {
  test::Gpu gpu;
  const auto [iterations, largest_error] =
      GENERATE(std::pair(10, 0.12), std::pair(20, gl::device().software ? 0.01 : 0.02));
  Model model = cube(0.2, 6, soft_tissue(2e4));
  for (Vector3d& v : model.initial_velocity) v = {0.3, -1.5, 0};
  model.tools = {tool("ground", PlaneShape{{0, -0.012, 0}, {0.1, 1, 0}}, 0.5)};
  GpuSolver solver(gpu.programs, model, awake(iterations));
  const double error = error_of_steps(solver, model, awake(iterations), 40);
  CAPTURE(iterations, error);
  CHECK(error < largest_error);
}

// A cube lies on a slab, which carries it, and a ball presses on the cube. The stage of BDF2 is shorter than its step,
// and the two of SDIRK2 take different parts of it. Root mean squares over all steps, each from the same state: of the
// largest distance to the exact step over that of its way.
TEST_CASE("tissue that lies on tissue follows the reference with every integrator", "[gpu][contact]") {
  test::Gpu gpu;
  SolverSettings settings = awake(GENERATE(10, 40));
  settings.integrator = GENERATE(Integrator::implicit_euler, Integrator::bdf2, Integrator::sdirk2);
  const double young_modulus = GENERATE(2e4, 2e5);
  Model model = test::cube_on_slope(0, 0.4, squared(young_modulus));
  model.tools = {tool("ball", SphereShape{{0, 0, 0}, 0.04}, 0.3,
                      {{0, {0.37, 0.26, 0.125}, {0, 0, 0}}, {0.4, {0.38, 0.23, 0.125}, {0, 0, 0}}})};
  GpuSolver solver(gpu.programs, model, settings);
  reference::NewtonSolver exact(model, settings);
  double errors = 0, ways = 0, pressed = 0;
  for (int i = 0; i < 36; ++i) {
    const State before = solver.download();
    State reference = before;
    exact.step(reference);
    solver.step();
    errors += std::pow(farthest(solver.download(), reference), 2);
    ways += std::pow(farthest(reference, before), 2);
    for (const auto& load : exact.pair_loads()) pressed = std::max(pressed, load.force.norm());
  }
  const double error = std::sqrt(errors / ways);
  CAPTURE(name_of(settings.integrator), settings.iterations, young_modulus, pressed, error);
  CHECK(pressed > 2 * 9.81);
  CHECK(error < (settings.iterations == 10 ? 0.05 : 0.02));
}

TEST_CASE("tissue in contact goes on to the same bits in another solver", "[gpu][contact]") {
  test::Gpu gpu;
  Model model = two_cubes({1, 0.3, 0});
  model.tools = {tool("wall", PlaneShape{{0, 0, 0}, {1, 0, 0}}, 0.5)};
  const auto [middle, a, b] = test::repeated(gpu, model, 3, 5);
  CHECK(a.displacement == b.displacement);
  CHECK(a.velocity == b.velocity);
  CHECK(a.contact == b.contact);
  const auto first_pair = static_cast<std::ptrdiff_t>(middle.contact.size() - PairSearch(model).row_count());
  CHECK(std::any_of(middle.contact.begin() + first_pair, middle.contact.end(),
                    [](const ContactForce& f) { return f.normal > 0; }));
}

// The mean displacements [m] of the cube, at the start and after every `interval` steps.
std::vector<Vector3d> way_down_slope(test::Gpu& gpu, const Model& model, int steps, int interval) {
  GpuSolver solver(gpu.programs, model, awake(10));
  std::vector<Vector3d> places;
  for (int i = 0; i <= steps; ++i) {
    if (i % interval == 0) places.push_back(test::mean_displacement_of_second(model, solver.download()));
    if (i < steps) solver.step();
  }
  return places;
}

// As the reference in tests/sim/contact/test_pair_cases.cpp
TEST_CASE("a soft cube rests on a slope of tissue with ten iterations, and slides down a steep one", "[gpu][contact]") {
  test::Gpu gpu;
  const Model gentle = test::cube_on_slope(0.7 * 0.4, 0.4, squared(1e4));
  const std::vector<Vector3d> resting = way_down_slope(gpu, gentle, 240, 60);
  const double creep = (resting[4] - resting[2]).norm() / 2;  // [m/s]
  const double slope = 1.2 * 0.4;
  const Model steep = test::cube_on_slope(slope, 0.4, soft_tissue(1e5, 0.05));
  const std::vector<Vector3d> sliding = way_down_slope(gpu, steep, 40, 10);
  const double acceleration = -(sliding[4] - 2 * sliding[3] + sliding[2]).x() * 36;
  const double coulomb = 9.81 / std::hypot(1, slope) * (slope - 0.4);
  CAPTURE(creep, resting[4].transpose(), acceleration, coulomb);
  CHECK(creep < 1e-5);
  CHECK(acceleration == Approx(coulomb).epsilon(0.05));
}

}  // namespace
}  // namespace fascia
