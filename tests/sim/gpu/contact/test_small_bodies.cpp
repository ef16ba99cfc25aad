// Bodies that are small and stiff: their weight is a millionth of the penalty times what float32 leaves of their
// places. Covers: sim/gpu/contact/body_motions, sim/gpu/contact/contact_term
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "sim/gpu/solver.h"
#include "tests/sim/gpu/contact/contact_scenes.h"
#include "tests/support/bare_shapes.h"
#include "tests/support/gpu/gpu_fixture.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kGravity = 9.81;

double mass_of(const Model& model) {
  double sum = 0;
  for (const double mass : consistent_masses(model)) sum += mass;
  return sum;
}

Vector3d velocity_of(const Model& model, const State& state) {
  const std::vector<double> masses = consistent_masses(model);
  Vector3d sum(0, 0, 0);
  for (std::size_t v = 0; v < masses.size(); ++v) sum += masses[v] * state.velocity[v];
  return sum / mass_of(model);
}

Vector3d force_on(GpuSolver& solver) {
  solver.request_diagnostics();
  return solver.take_diagnostics(true)->tool_loads[0].force;
}

}  // namespace

// It turns by up to a third of a radian in a step, from facet to facet. Before turned arms were in its curvature, and
// forces those of the places that it was moved to, the mean force was 0.64 to 0.95 of the weight's.
TEST_CASE("a small ball that slides and rolls down a slope presses with its weight, and has Coulomb's acceleration",
          "[gpu][contact]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  const double young_modulus = GENERATE(1e5, 1e6, 1e7);
  constexpr double kFriction = 0.1, kSlope = std::numbers::pi / 6, kRadius = 0.01;
  test::Gpu gpu(loads);
  Material material = test::soft_tissue(young_modulus);
  material.poisson_ratio = 0.45;
  Model model = test::make_model(test::make_ball(kRadius, 6), material, [](const Vector3d&) { return false; });
  const Vector3d up(std::sin(kSlope), std::cos(kSlope), 0), down(std::cos(kSlope), -std::sin(kSlope), 0);
  model.gravity = {0, -kGravity, 0};
  double lowest = 0;
  for (const Vector3d& x : model.rest_positions) lowest = std::min(lowest, up.dot(x));
  model.tools = {test::tool("slope", PlaneShape{lowest * up, up}, kFriction)};
  SolverSettings settings = test::two_level();
  settings.rest_speed = 0;
  GpuSolver solver(gpu.programs, model, settings);
  constexpr int kFirst = 15, kSteps = 45;
  for (int i = 0; i < kFirst; ++i) solver.step();
  const Vector3d before = velocity_of(model, solver.download());
  Vector3d sum(0, 0, 0);
  for (int i = kFirst; i < kSteps; ++i) {
    solver.step();
    sum += force_on(solver);
  }
  const double duration = (kSteps - kFirst) / 60.0, weight = mass_of(model) * kGravity * std::cos(kSlope);
  const Vector3d gained = velocity_of(model, solver.download()) - before, force = sum / (kSteps - kFirst);
  const double coulomb = kGravity * (std::sin(kSlope) - kFriction * std::cos(kSlope));
  CAPTURE(gl::name_of(loads), young_modulus, force.dot(up) / weight, gained.dot(down) / duration / coulomb);
  CHECK(force.dot(up) == Approx(weight).epsilon(0.02));
  CHECK(gained.dot(down) / duration == Approx(coulomb).epsilon(0.02));
}

// Squeezed by two micrometers: float32 places of its faces are a nanometer apart. Forces rose and fell by 4 % for good
// while places in contact were without what their sum loses.
TEST_CASE("the force on a stiff cube between plates is steady", "[gpu][contact]") {
  constexpr double kHalf = 0.02, kSqueeze = 0.94e-6;  // [m] on each side
  test::Gpu gpu;
  Material material = test::soft_tissue(1e7, 0.02);
  material.poisson_ratio = 0.4;
  Model model = test::cube(2 * kHalf, 4, material);
  model.gravity = {0, 0, 0};
  for (Vector3d& x : model.rest_positions) x -= Vector3d(kHalf, 0, kHalf);
  for (const double side : {-1.0, 1.0}) {
    const auto at = [&](double beyond) { return Vector3d(side * (0.01 + kHalf + beyond), kHalf, 0); };
    model.tools.push_back(test::tool(side < 0 ? "left" : "right", BoxShape{{0, 0, 0}, {0.01, 0.03, 0.03}, 0}, 0.5,
                                     {{0, at(1e-4), {0, 0, 0}}, {0.1, at(-kSqueeze), {0, 0, 0}}}));
  }
  SolverSettings settings = test::two_level();
  settings.rest_speed = 0;
  GpuSolver solver(gpu.programs, model, settings);
  for (int i = 0; i < 40; ++i) solver.step();
  double least = 1e30, most = 0;
  for (int i = 0; i < 80; ++i) {
    solver.step();
    const double force = force_on(solver).x();
    least = std::min(least, force);
    most = std::max(most, force);
  }
  CAPTURE(least, most);
  CHECK(least > 0.6);  // 0.75 N without friction
  CHECK(most < 1.0);
  CHECK(most - least < 1e-3 * most);
}

// Before forces were those of depths in double precision, those of 5 mm slid by two to three of their sides.
TEST_CASE("a small cube on a turned box stays where friction holds it", "[gpu][contact]") {
  const auto [side, young_modulus] =
      GENERATE(table<double, double>({{0.005, 1e6}, {0.01, 1e6}, {0.02, 1e6}, {0.02, 1e7}}));
  const Integrator integrator = GENERATE(Integrator::implicit_euler, Integrator::bdf2);
  constexpr double kFriction = 0.5, kShare = 0.95;  // of the limit
  test::Gpu gpu;
  Material material = test::soft_tissue(young_modulus);
  material.poisson_ratio = 0.4;
  Model model = test::cube(side, 4, material);
  const Eigen::AngleAxisd turn(std::atan(kShare * kFriction), Vector3d(1, 0, 1).normalized());
  const Vector3d up = turn * Vector3d::UnitY();
  for (Vector3d& x : model.rest_positions) x = turn * Vector3d(x + Vector3d(0.01 - side / 2, 0.01, -0.007 - side / 2));
  const Vector3d angles = turn.toRotationMatrix().eulerAngles(2, 1, 0).reverse() * (180 / std::numbers::pi);
  model.tools = {test::tool("box", BoxShape{{0, 0, 0}, {0.04, 0.01, 0.04}, 0}, kFriction, {{0, {0, 0, 0}, angles}})};
  SolverSettings settings = test::two_level();
  settings.rest_speed = 0;
  settings.integrator = integrator;
  GpuSolver solver(gpu.programs, model, settings);
  const double weight = mass_of(model) * kGravity * up.y();
  State early;
  for (int i = 0; i < 180; ++i) {
    solver.step();
    if (i == 20) early = solver.download();
  }
  const State late = solver.download();
  double moved = 0;
  for (std::size_t v = 0; v < late.displacement.size(); ++v)
    moved = std::max(moved, (late.displacement[v] - early.displacement[v]).norm());
  const double pressing = force_on(solver).dot(up);
  CAPTURE(side, young_modulus, name_of(integrator), moved / side, pressing / weight);
  CHECK(moved < 0.001 * side);
  CHECK(pressing == Approx(weight).epsilon(1e-3));
}

}  // namespace fascia
