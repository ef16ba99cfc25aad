// A beam falls alike for any number of tets: sums over a million of them must not stop a step. 5k to 331k tets are in
// the slow tests.
#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "sim/gpu/static_march.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;

namespace {

// Cells along the beam's length of 1 m; a quarter as many across.
Model beam(int cells) {
  return make_model(make_box(cells, cells / 4, cells / 4, {1, 0.25, 0.25}),
                    {1e6, 0.3, 1000, 0, MaterialModel::st_venant_kirchhoff},
                    [](const Eigen::Vector3d& x) { return x.x() < 1e-9; });
}

double lowest(const State& state) {
  double y = 0;
  for (const Eigen::Vector3d& u : state.displacement) y = std::min(y, u.y());
  return y;
}

constexpr int kSteps = 6;

// Of the double-precision solver, on a mesh that it can step in seconds.
double exact_tip() {
  const Model model = beam(16);
  State state = initial_state(model);
  reference::NewtonSolver newton(model, {});
  for (int i = 0; i < kSteps; ++i) newton.step(state);
  return lowest(state);
}

void check_fall(int cells) {
  const Model model = beam(cells);
  Gpu gpu;
  GpuSolver solver(gpu.programs, model, {});
  solver.finish_background();
  for (int i = 0; i < kSteps; ++i) solver.step();
  const double tip = lowest(solver.download()), exact = exact_tip();
  CAPTURE(model.tets.size(), tip, exact);
  // The coarse mesh of linear tets is stiffer: its tip hangs 1.0 % higher than that of a million tets.
  CHECK(tip == Approx(exact).epsilon(0.015));
}

}  // namespace

TEST_CASE("a beam of a million tets falls like a small one", "[gpu]") { check_fall(140); }

TEST_CASE("beams of 5,184 to 331,776 tets fall alike", "[gpu][slow]") { check_fall(GENERATE(24, 48, 64, 96)); }

TEST_CASE("static equilibria of beams of 5,184 to 1,029,000 tets", "[gpu][slow]") {
  const Model model = beam(GENERATE(24, 48, 64, 96, 140));
  Gpu gpu;
  GpuSolver solver(gpu.programs, model, {});
  State equilibrium;
  const reference::NewtonReport report = march_to_equilibrium(solver, model, {1e-5}, equilibrium);
  CAPTURE(model.tets.size(), report.iterations, report.relative_residual, lowest(equilibrium));
  CHECK(report.converged);
  CHECK(report.relative_residual <= 1e-5);
}
