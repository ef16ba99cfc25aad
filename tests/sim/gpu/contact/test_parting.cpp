// Bodies that begin nearer to each other than the skin that is left between surfaces.
// Covers: pair_stage
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/contact/pair_search.h"
#include "sim/gpu/solver.h"
#include "tests/sim/gpu/contact/contact_scenes.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/touching_bodies.h"

namespace fascia {

using Eigen::Vector3d;

// They had 28 times their energy: parted by a quarter of the skin in each step, they left each other at 1 m/s.
TEST_CASE("bodies that begin within the skin and close slowly gain no energy in short steps", "[gpu][contact]") {
  test::Gpu gpu;
  const double share = GENERATE(0.05, 0.3);  // of the skin
  constexpr double kSpeed = 0.2, kSize = 0.12;
  Material material = test::soft_tissue(2e6);
  material.poisson_ratio = 0.35;
  const Model lower = test::moved(test::cube(kSize, 3, material), {0, 0, 0}, {0, kSpeed / 2, 0});
  const auto at_gap = [&](double gap) {
    Model model = test::beside(
        lower, test::moved(test::cube(kSize, 3, material), {0.01, kSize + gap, 0.02}, {0, -kSpeed / 2, 0}), "upper");
    model.gravity.setZero();
    return model;
  };
  const double skin = PairSearch(at_gap(1)).skin();
  const Model model = at_gap(share * skin);
  GpuSolver solver(gpu.programs, model, test::awake(Integrator::implicit_euler, 960));
  const std::vector<double> masses = consistent_masses(model);
  const auto kinetic = [&] {
    const State state = solver.download();
    double energy = 0;
    for (std::size_t v = 0; v < masses.size(); ++v) energy += 0.5 * masses[v] * state.velocity[v].squaredNorm();
    return energy;
  };
  const double before = kinetic();
  double most = 0;
  for (int i = 0; i < 100; ++i) {
    solver.step();
    most = std::max(most, kinetic());
  }
  const double parting = test::mean_displacement_of_second(model, solver.download()).y();
  CAPTURE(share, skin, before, most, parting);
  CHECK(most <= 1.001 * before);
  CHECK(parting > -0.5 * skin);  // and it did stop
}

// It stood for half a second where it should slide: vertices of the slab beside its edges were within its skin.
TEST_CASE("a small block that is set on tissue without a gap slides down a steep slope", "[gpu][contact]") {
  test::Gpu gpu;
  constexpr double kFriction = 0.3, kSize = 0.006, kSteep = 1.5;
  Model slab = test::make_model(make_box(12, 2, 6, {0.06, 0.008, 0.024}), test::soft_tissue(1e6, 0.005),
                                [](const Vector3d& x) { return x.y() < 1e-6; });
  Model block = test::make_model(make_box(4, 2, 3, {0.009, kSize, 0.009}), test::soft_tissue(1e5, 0.005),
                                 [](const Vector3d&) { return false; });
  Model model = test::beside(slab, test::moved(block, {0.0113, 0.008, 0.0071}), "block");
  const double slope = std::atan(kSteep * kFriction);
  model.gravity = 9.81 * Vector3d(std::sin(slope), -std::cos(slope), 0);
  model.contact.friction = kFriction;
  GpuSolver solver(gpu.programs, model, test::awake(Integrator::implicit_euler, 240));
  constexpr int kSteps = 48;
  for (int i = 0; i < kSteps; ++i) solver.step();
  const double way = test::mean_displacement_of_second(model, solver.download()).x();
  const double coulomb = 9.81 * (std::sin(slope) - kFriction * std::cos(slope)), time = kSteps / 240.0;
  const double expected = coulomb * time * time / 2;
  // The first touch has no friction in its first step.
  const double without = kFriction * 9.81 * std::cos(slope) / 240 * time;
  CAPTURE(way, expected, without);
  CHECK(way > 0.6 * expected);
  CHECK(way < 1.02 * (expected + without));
}

}  // namespace fascia
