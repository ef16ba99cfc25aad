// Nearly incompressible quadratic tets, whose K is relaxed within the iterations
// (sim/quadratic/quadratic_multiplier.comp), against the reference solver. Covers: two_level, coarse_level
#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

Model held_beam(double nu) {
  const Material material{2.5e5, nu, 1000, 0, MaterialModel::squared};
  return quadratic(
      make_model(make_box(8, 2, 2, {0.4, 0.1, 0.1}), material, [](const Vector3d& x) { return x.x() < 1e-9; }));
}

SolverSettings with_iterations(int iterations) {
  SolverSettings settings;
  settings.iterations = iterations;
  settings.rest_speed = 0;
  return settings;
}

}  // namespace

// With the whole K in the iterations the errors of 4, 8 and 30 are 3.4e-2, 5.5e-3 and 3.0e-5 at 0.49, and 0.25, 0.1 and
// 8.2e-3 at 0.499.
TEST_CASE("a released beam of quadratic tets needs no more iterations the less it is compressible", "[gpu]") {
  const double nu = GENERATE(0.49, 0.499);
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  Gpu gpu(loads);
  const Model model = held_beam(nu);
  std::vector<Vector3d> expected;  // of all steps
  State exact = initial_state(model);
  reference::NewtonSolver reference(model, with_iterations(1));
  for (int k = 0; k < 30; ++k) {
    REQUIRE(reference.step(exact).converged);
    expected.insert(expected.end(), exact.displacement.begin(), exact.displacement.end());
  }
  for (const auto& [iterations, most] : {std::pair(4, 1e-2), std::pair(8, 3e-3), std::pair(30, 1e-5)}) {
    GpuSolver solver(gpu.programs, model, with_iterations(iterations));
    std::vector<Vector3d> reached;
    for (int k = 0; k < 30; ++k) {
      solver.step();
      const State state = solver.download();
      reached.insert(reached.end(), state.displacement.begin(), state.displacement.end());
    }
    const double error = relative_rms(reached, expected);
    CAPTURE(nu, iterations, error);
    CHECK(error < most);
  }
}

TEST_CASE("steps of nearly incompressible quadratic tets repeat to the bit from a state that is set", "[gpu]") {
  Gpu gpu;
  const Model model = held_beam(0.499);
  GpuSolver solver(gpu.programs, model, with_iterations(10));
  for (int k = 0; k < 5; ++k) solver.step();
  const State set = solver.download();
  std::vector<State> ends;
  for (int run = 0; run < 2; ++run) {
    solver.upload(set);
    for (int k = 0; k < 5; ++k) solver.step();
    ends.push_back(solver.download());
  }
  CHECK(ends[0].displacement == ends[1].displacement);
}

TEST_CASE("quadratic tets go on where a Poisson's ratio that changes begins or ends to be relaxed", "[gpu]") {
  const double before = GENERATE(0.3, 0.495), after = before < 0.4 ? 0.495 : 0.3;
  Gpu gpu;
  Model model = held_beam(before);
  GpuSolver solver(gpu.programs, model, with_iterations(30));
  reference::NewtonSolver first(model, with_iterations(1));
  State exact = initial_state(model);
  for (int k = 0; k < 4; ++k) {
    solver.step();
    REQUIRE(first.step(exact).converged);
  }
  model.materials[0].poisson_ratio = after;
  solver.materials_changed();
  solver.finish_background();
  reference::NewtonSolver second(model, with_iterations(1));
  for (int k = 0; k < 4; ++k) {
    solver.step();
    REQUIRE(second.step(exact).converged);
  }
  const double error = relative_rms(solver.download().displacement, exact.displacement);
  CAPTURE(before, after, error);
  CHECK(error < 1e-3);
}
