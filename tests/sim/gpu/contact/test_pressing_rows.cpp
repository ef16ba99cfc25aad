// Iterations whose steps know what begins or ceases to press (shaders/sim/two_level/pressing_step.glsl), against exact
// steps.
// Covers: contact_passes
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/gpu/solver.h"
#include "sim/reference/newton.h"
#include "tests/sim/gpu/contact/contact_scenes.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/touching_bodies.h"

namespace fascia {

using Eigen::Vector3d;

namespace {

double energy_within(const Model& model, const State& state) {
  const reference::Measures measured = reference::measure(model, state);
  return measured.kinetic + measured.elastic;
}

Model bar(double stiffness, double length) {
  const int cells = static_cast<int>(std::lround(length / 0.06));
  Material material = test::soft_tissue(stiffness);
  material.poisson_ratio = 0;
  return test::make_model(make_box(cells, 2, 2, {length, 0.12, 0.12}), material, [](const Vector3d&) { return false; });
}

}  // namespace

// By iterations that did not know it, bodies that let go in the steps after a hit were pushed apart: they had 1.2 to 2
// times their energy, and 0.7 to 0.9 times by exact steps.
TEST_CASE("ten iterations follow bars that hit each other to their exact steps", "[gpu][contact]") {
  test::Gpu gpu;
  const Integrator integrator = GENERATE(Integrator::bdf2, Integrator::sdirk2);
  const double stiffness = GENERATE(2e4, 3e6);
  constexpr double kLength = 0.48, kSpeed = 0.4, kGap = 0.001;
  Model model = test::beside(test::moved(bar(stiffness, kLength), {0, 0, 0}, {kSpeed, 0, 0}),
                             test::moved(bar(stiffness, kLength), {kLength + kGap, 0, 0}), "second");
  model.gravity.setZero();
  GpuSolver solver(gpu.programs, model, test::awake(integrator));
  reference::NewtonSolver newton(model, test::awake(integrator));
  State exact = initial_state(model);
  const double before = energy_within(model, exact);
  double most = 0, most_exact = before, difference = 0;
  for (int i = 0; i < 16; ++i) {
    solver.step();
    newton.step(exact);
    const double energy = energy_within(model, solver.download());
    most = std::max(most, energy);
    most_exact = std::max(most_exact, energy_within(model, exact));
    difference = std::max(difference, std::abs(energy - energy_within(model, exact)));
  }
  CAPTURE(name_of(integrator), stiffness, before, most, most_exact, difference);
  CHECK(most <= 1.01 * most_exact);
  CHECK(difference < 0.02 * before);
}

// They had a million times the elastic energy of exact steps: to lift the upper one out of the skin, iterations
// squeezed both.
TEST_CASE("stiff blocks that are set on each other bear their weight, and no more", "[gpu][contact]") {
  test::Gpu gpu;
  constexpr double kSize = 0.03, kHeight = 0.015;
  const double stiffness = GENERATE(1e6, 1e8);
  const auto block = [&] {
    return test::make_model(make_box(3, 2, 3, {kSize, kHeight, kSize}), test::soft_tissue(stiffness, 0.01),
                            [](const Vector3d&) { return false; });
  };
  Model model = test::beside(block(), test::moved(block(), {0.004, kHeight, 0.003}), "upper");
  model.gravity = {0, -9.81, 0};
  model.contact.friction = 0.5;
  model.tools = {test::tool("ground", PlaneShape{{0, 0, 0}, {0, 1, 0}}, 0.5)};
  GpuSolver solver(gpu.programs, model, test::awake(Integrator::implicit_euler));
  reference::NewtonSolver newton(model, test::awake(Integrator::implicit_euler));
  State exact = initial_state(model);
  double most = 0, most_exact = 0;
  for (int i = 0; i < 20; ++i) {
    solver.step();
    newton.step(exact);
    most = std::max(most, reference::measure(model, solver.download()).elastic);
    most_exact = std::max(most_exact, reference::measure(model, exact).elastic);
  }
  CAPTURE(stiffness, most, most_exact);
  CHECK(most < 3 * most_exact);
}

// The side of the block met the slab's vertices ahead of it, which it slides over, and stopped within some steps.
TEST_CASE("a block that begins to slide on the tissue that it is set on goes on", "[gpu][contact]") {
  test::Gpu gpu;
  constexpr double kSpeed = 0.6;
  constexpr int kSteps = 12;
  const double turn = GENERATE(0.0, 0.17, 0.6);  // [rad] about the normal
  const Material tissue = test::soft_tissue(2e5, 0.02);
  const Model slab =
      test::make_model(make_box(30, 3, 12, {0.3, 0.03, 0.12}), tissue, [](const Vector3d& x) { return x.y() < 1e-9; });
  Model block = test::make_model(make_box(5, 3, 5, {0.05, 0.03, 0.05}), tissue, [](const Vector3d&) { return false; });
  const Eigen::Matrix3d turned(Eigen::AngleAxisd(turn, Vector3d::UnitY()));
  for (Vector3d& x : block.rest_positions) x = turned * (x - Vector3d(0.025, 0, 0.025)) + Vector3d(0.23, 0.03, 0.06);
  Model model = test::beside(slab, test::moved(block, {0, 0, 0}, {-kSpeed, 0, 0}), "block");
  model.gravity = {0, -9.81, 0};
  model.contact.friction = 0;
  const SolverSettings settings = test::awake(Integrator::implicit_euler);
  const double way = kSpeed * kSteps * settings.time_step;
  GpuSolver solver(gpu.programs, model, settings);
  reference::NewtonSolver newton(model, settings);
  State exact = initial_state(model);
  for (int i = 0; i < kSteps; ++i) {
    solver.step();
    newton.step(exact);
  }
  const double here = -test::mean_displacement_of_second(model, solver.download()).x(),
               by_reference = -test::mean_displacement_of_second(model, exact).x();
  CAPTURE(turn, way, here, by_reference);
  CHECK(here > 0.9 * way);
  CHECK(by_reference > 0.9 * way);
}

}  // namespace fascia
