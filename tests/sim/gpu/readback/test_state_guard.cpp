// The state guard: the states that count as diverged, and the state that it restores.
#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "sim/gpu/solver.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

std::optional<std::uint32_t> diverged(GpuSolver& solver) {
  solver.request_check();
  const auto verdict = solver.take_check(true);
  REQUIRE(verdict);
  return verdict->diverged;
}

// The bar with one vertex at another place.
State with_vertex(const Model& model, std::uint32_t vertex, const Vector3d& displacement) {
  State state = initial_state(model);
  state.displacement[vertex] = displacement;
  return state;
}

constexpr std::uint32_t kVertex = 70;

}  // namespace

TEST_CASE("the first vertex that is not finite, by its index, is recorded", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  const double value = GENERATE(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity());
  Gpu gpu(loads);
  const Model model = bar();
  GpuSolver solver(gpu.programs, model, with(SolverChoice{Method::two_level, Acceleration::nonlinear_cg}));
  solver.step();
  CHECK(diverged(solver) == std::nullopt);
  solver.upload(with_vertex(model, kVertex, Vector3d(0, value, 0)));
  solver.step();
  const auto lost = diverged(solver);
  REQUIRE(lost);
  // One step with sums over the whole mesh spreads it to all free vertices.
  CHECK(*lost <= kVertex);
  CHECK(model.held()[*lost] == 0);
}

TEST_CASE("a free fall of any length and a fast start do not count as divergence", "[gpu]") {
  Gpu gpu;
  Model model = free_bar();
  model.gravity = {0, -9.81, 0};
  for (Vector3d& v : model.initial_velocity) v = {1000, 0, 0};
  GpuSolver solver(gpu.programs, model, with(SolverChoice{Method::two_level, Acceleration::nonlinear_cg}));
  for (int i = 0; i < 30; ++i) solver.step();
  CHECK(solver.download().displacement[0].x() > 400);
  CHECK(diverged(solver) == std::nullopt);
}

TEST_CASE("the guard measures the displacement since the last check, the speed and the total displacement", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  Gpu gpu(loads);
  const Model model = free_bar();
  GpuSolver solver(gpu.programs, model, with(SolverChoice{Method::two_level, Acceleration::nonlinear_cg}));
  State start = initial_state(model);
  for (Vector3d& u : start.displacement) u = {0, 0.3, 0};
  for (Vector3d& v : start.velocity) v = {0, 0, 0.6};
  solver.upload(start);
  for (int i = 0; i < 6; ++i) solver.step();
  solver.request_check();
  const auto verdict = solver.take_check(true);
  REQUIRE(verdict);
  CHECK(verdict->movement.duration == Approx(0.1));
  CHECK(verdict->movement.way == Approx(0.06).epsilon(1e-4));
  CHECK(verdict->movement.speed == Approx(0.6).epsilon(1e-4));
  CHECK(verdict->movement.displacement == Approx(std::hypot(0.3, 0.06)).epsilon(1e-4));
}

TEST_CASE("a vertex that its forces throw out of the scene is recorded", "[gpu]") {
  Gpu gpu;
  const Model model = bar();
  GpuSolver solver(gpu.programs, model, with(SolverChoice{Method::jacobi, Acceleration::none}));
  // 1000 sizes away: the distance back is as long.
  solver.upload(with_vertex(model, kVertex, Vector3d(0, 200, 0)));
  for (int i = 0; i < 3; ++i) solver.step();
  CHECK(diverged(solver));
}

TEST_CASE("the last valid state is restored to the bit, and the simulation continues as before", "[gpu]") {
  Gpu gpu;
  const Model model = bar();
  GpuSolver solver(gpu.programs, model, with(SolverChoice{Method::two_level, Acceleration::nonlinear_cg}));
  for (int i = 0; i < 5; ++i) solver.step();
  REQUIRE(diverged(solver) == std::nullopt);
  const State sound = solver.download();
  solver.step();
  const State next = solver.download();
  const bool at_rest = GENERATE(false, true);
  for (int i = 0; i < 3; ++i) solver.step();
  solver.restore_valid(at_rest);
  const State back = solver.download();
  CHECK(back.displacement == sound.displacement);
  CHECK(back.time == sound.time);
  if (at_rest) {
    CHECK(back.velocity == std::vector<Vector3d>(back.velocity.size(), Vector3d::Zero()));
    return;
  }
  CHECK(back.velocity == sound.velocity);
  solver.step();
  CHECK(solver.download().displacement == next.displacement);
  CHECK(solver.download().velocity == next.velocity);
}

TEST_CASE("an uploaded state counts as valid until steps show otherwise", "[gpu]") {
  Gpu gpu;
  const Model model = bar();
  GpuSolver solver(gpu.programs, model, with(SolverChoice{Method::two_level, Acceleration::nonlinear_cg}));
  const State start = random_state(model, 0.005, 4);
  solver.upload(start);
  for (int i = 0; i < 2; ++i) solver.step();
  solver.restore_valid(false);
  CHECK(solver.download().displacement == start.displacement);
}
