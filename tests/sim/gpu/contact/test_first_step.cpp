// Covers: sim/contact/first_state
// What the forces with which a scene begins do in its first steps, on the GPU and in the reference.
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/contact/first_state.h"
#include "sim/gpu/solver.h"
#include "sim/reference/newton.h"
#include "tests/sim/contact/grasp.h"
#include "tests/sim/gpu/contact/contact_scenes.h"
#include "tests/support/gpu/gpu_fixture.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using test::soft_tissue;
using test::two_level;

// v^2 / (2 mu g), of which implicit Euler, whose steps have the speed of their end, lacks v h / 2. Without friction in
// the first step the ways are 8 to 23 % longer than v^2 / (2 mu g).
TEST_CASE("a block that begins on the ground with a speed slides as far as friction lets it", "[gpu][contact]") {
  constexpr double kGravity = 9.81, kFriction = 0.4, kSpeed = 0.9;
  test::Gpu gpu;
  SolverSettings settings = two_level();
  settings.integrator = GENERATE(Integrator::implicit_euler, Integrator::bdf2, Integrator::sdirk2);
  settings.rest_speed = 0;
  Model model = test::cube(0.1, 3, soft_tissue(1e5, 0.05));
  model.initial_velocity.assign(model.rest_positions.size(), {kSpeed, 0, 0});
  model.tools = {test::tool("ground", PlaneShape{{0, 0, 0}, {0, 1, 0}}, kFriction)};
  const double missing = settings.integrator == Integrator::implicit_euler ? kSpeed * settings.time_step / 2 : 0;
  const double exact = kSpeed * kSpeed / (2 * kFriction * kGravity) - missing;

  GpuSolver solver(gpu.programs, model, settings);
  reference::NewtonSolver newton(model, settings);
  State state = first_state(model);
  for (int i = 0; i < 45; ++i) {
    solver.step();
    newton.step(state);
  }
  const double way = test::mean(solver.download().displacement).x(), reference_way = test::mean(state.displacement).x();
  CAPTURE(name_of(settings.integrator), way, reference_way, exact);
  CHECK(way == Approx(exact).epsilon(0.03));
  CHECK(reference_way == Approx(exact).epsilon(0.03));
}

// Without friction in its first step a body falls by g h^2 = 2.7 mm, and slides on.
TEST_CASE("a cube that two plates squeeze from the start is held by friction", "[gpu][contact]") {
  test::Gpu gpu;
  SolverSettings settings = two_level();
  settings.integrator = GENERATE(Integrator::implicit_euler, Integrator::bdf2);
  settings.rest_speed = 0;
  constexpr double kSize = 0.04, kSqueeze = 0.0005;
  Model model = test::cube(kSize, 4, soft_tissue(5e4, 0.02));
  const BoxShape plate{{0, 0, 0}, {0.01, 0.06, 0.06}, 0};
  double left = 1e9, right = -1e9;
  for (const Vector3d& x : model.rest_positions) {
    left = std::min(left, x.x());
    right = std::max(right, x.x());
  }
  model.tools = {test::tool("left", plate, 0.5), test::tool("right", plate, 0.5)};
  model.tools[0].path[0].position.x() = left - 0.01 + kSqueeze;
  model.tools[1].path[0].position.x() = right + 0.01 - kSqueeze;

  GpuSolver solver(gpu.programs, model, settings);
  reference::NewtonSolver newton(model, settings);
  State state = first_state(model);
  for (int i = 0; i < 40; ++i) {
    solver.step();
    newton.step(state);
  }
  const State now = solver.download();
  CAPTURE(name_of(settings.integrator), test::mean(now.displacement).y(), test::mean(state.displacement).y(),
          test::mean(now.velocity).y());
  CHECK(test::mean(now.displacement).y() > -0.0005);
  CHECK(test::mean(state.displacement).y() > -0.0005);
  CHECK(std::abs(test::mean(now.velocity).y()) < 1e-3);
  CHECK(std::abs(test::mean(state.velocity).y()) < 1e-3);
}

}  // namespace
}  // namespace fascia
