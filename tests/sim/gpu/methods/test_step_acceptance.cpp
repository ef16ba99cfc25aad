// The acceptance of steps of the two-level method: sums that are equal to the bit in all kernels, and the part of a
// step that is kept if it raised the objective.
#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <random>

#include "gl/compute_pass.h"
#include "shaders/shared/types.h"
#include "sim/gpu/solver.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;
using shared::vec4;

namespace {

// The output of the first work groups for subspace_solve: three arrays of partials of vertices, then those of the
// curvature.
struct Partials {
  explicit Partials(std::uint32_t count) : vertices(count), values(4 * count, vec4{0, 0, 0, 0}) {}
  std::uint32_t vertices;
  std::vector<vec4> values;
  vec4& slopes(std::uint32_t k) { return values[k]; }                  // x g.z_f, y g.z_c, z g.p, w objective
  vec4& masses(std::uint32_t k) { return values[vertices + k]; }       // w p M p
  vec4& secants(std::uint32_t k) { return values[2 * vertices + k]; }  // z p.y
};

struct Solve {
  explicit Solve(gl::LoadPath loads) : gpu(loads) {}
  Gpu gpu;
  gl::Buffer state{"subspace_state", std::vector<float>(8, 0)};

  void guess(const Partials& partials) {
    const gl::Buffer buffer("dot_partials", partials.values);
    gl::ComputePass(gpu.programs.compute("sim/two_level/guess_objective.comp"),
                    {{"dot_partials", &buffer}, {"subspace_state", &state}}, 1, {{"partials", partials.vertices}})
        .run();
  }
  void solve(const Partials& partials) {
    const gl::Buffer buffer("dot_partials", partials.values);
    gl::ComputePass(gpu.programs.compute("sim/two_level/subspace_solve.comp", {{"FINAL", "0"}}),
                    {{"dot_partials", &buffer}, {"subspace_state", &state}}, 1,
                    {{"partials", partials.vertices}, {"curvature_count", partials.vertices}, {"remembers", 1}})
        .run();
  }
  float objective() const { return state.read<float>()[0]; }
  float kept() const { return 1 + state.read<float>()[3]; }  // part of p
  bool accepted() const { return state.read<float>()[7] > 0.5f; }
};

}  // namespace

TEST_CASE("one state has one objective, to the bit, for any number of partial sums", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  const std::uint32_t count = GENERATE(1u, 7u, 64u, 192u, 1427u, 5000u);
  std::mt19937 random(count);
  std::lognormal_distribution<float> size(0, 3);
  Partials partials(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    partials.slopes(k).w = size(random);
    partials.masses(k).w = 1e-6f;  // a step that has moved a vertex
  }
  double exact = 0;
  for (std::uint32_t k = 0; k < count; ++k) exact += partials.slopes(k).w;
  Solve s(loads);
  s.guess(partials);
  const float before = s.objective();
  s.solve(partials);
  CAPTURE(gl::name_of(loads), count, before, s.objective(), exact);
  CHECK(s.accepted());
  CHECK(std::bit_cast<std::uint32_t>(s.objective()) == std::bit_cast<std::uint32_t>(before));
  // Kahan's correction within a slice; at most 16 slices are added without it.
  CHECK(std::abs(before - exact) <= 17 * 6e-8 * exact);
}

TEST_CASE("an empty step is kept, whatever the rounding", "[gpu]") {
  Solve s(GENERATE(gl::LoadPath::texel, gl::LoadPath::storage));
  Partials partials(1);
  partials.slopes(0).w = 1;
  s.guess(partials);
  partials.slopes(0).w = 1.001f;
  const bool moved = GENERATE(false, true);
  partials.masses(0).w = moved ? 1e-6f : 0;
  s.solve(partials);
  CAPTURE(moved, s.accepted());
  CHECK(s.accepted() == !moved);
}

TEST_CASE("the part that is kept of a step uphill is where the objective along it is smallest", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  // E(t) = 2 + slope t + c t^n, whose minimum is at t = least.
  const double exponent = GENERATE(2.0, 2.5, 3.0, 4.0), least = GENERATE(0.01, 0.04, 0.2, 0.45);
  const double c = 0.5, slope = -exponent * c * std::pow(least, exponent - 1);
  Partials partials(1);
  partials.slopes(0).w = 2;
  Solve s(loads);
  s.guess(partials);
  partials.slopes(0) = {0, 0, static_cast<float>(slope + exponent * c), static_cast<float>(2 + slope + c)};
  partials.masses(0).w = 1e-6f;
  partials.secants(0).z = static_cast<float>(exponent * c);
  s.solve(partials);
  CAPTURE(gl::name_of(loads), exponent, least, s.kept());
  CHECK_FALSE(s.accepted());
  // The initial slope is a difference of the other two, so it has their rounding; t depends on its (n - 1)-th root.
  const double rounding = 1.2e-7 * (2 + exponent * c) / std::abs(slope);
  CHECK(s.kept() == Approx(least).epsilon(rounding / (exponent - 1) + 1e-6));
}

TEST_CASE("at most half is kept of a step uphill, and nothing of one without a descending slope", "[gpu]") {
  Solve s(GENERATE(gl::LoadPath::texel, gl::LoadPath::storage));
  Partials partials(1);
  partials.slopes(0).w = 1;
  s.guess(partials);
  partials.masses(0).w = 1e-6f;
  SECTION("at most half") {
    partials.slopes(0) = {0, 0, 0.1f, 1.001f};
    partials.secants(0).z = 0.12f;  // initial slope: -0.02, so n = 4 and the minimum is at 0.62
    s.solve(partials);
    CAPTURE(s.kept());
    CHECK(s.kept() == 0.5f);
  }
  SECTION("nothing") {
    partials.slopes(0) = {0, 0, 0.02f, 1.001f};
    partials.secants(0).z = 0.01f;  // initial slope: 0.01
    s.solve(partials);
    CAPTURE(s.kept());
    CHECK(s.kept() == 0.0f);
  }
  CHECK_FALSE(s.accepted());
}

// At its first turning point, in step 23, the start u_n + h v_n of this beam lies uphill, and the objective along it is
// a parabola.
TEST_CASE("three iterations per step follow a beam through its turning point", "[gpu]") {
  const Model model =
      make_model(make_box(24, 6, 6, {1, 0.25, 0.25}), {1e6, 0.3, 1000, 0, MaterialModel::st_venant_kirchhoff},
                 [](const Eigen::Vector3d& x) { return x.x() < 1e-9; });
  SolverSettings settings;
  settings.iterations = 3;
  Gpu gpu;
  GpuSolver solver(gpu.programs, model, settings);
  solver.finish_background();
  reference::NewtonSolver newton(model, settings);
  State exact = initial_state(model);
  for (int i = 0; i < 25; ++i) {
    solver.step();
    newton.step(exact);
  }
  const double error = relative_rms(solver.download().displacement, exact.displacement);
  CAPTURE(error);
  CHECK(error < 1e-3);  // 9e-3 if all iterations of step 23 are spent on backtracking, 7e-5 if one is
}
