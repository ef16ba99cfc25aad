// The accelerations alone, on linear fixed-point iterations with known solutions: x <- A x + b with A diagonal,
// computed on the CPU between their passes.
// Covers: anderson, chebyshev
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/gpu/acceleration/anderson.h"
#include "sim/gpu/acceleration/chebyshev.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using shared::vec4;

namespace {

constexpr std::uint32_t kVertices = 200;

// x* = b / (1 - a) per component; the error of component i shrinks by a_i each plain iteration.
struct LinearIteration {
  std::vector<double> factor = std::vector<double>(3 * kVertices);
  gl::Buffer start{"start", 16 * kVertices}, displacement{"displacement", 16 * kVertices};
  gl::Buffer step{"step", sizeof(shared::StepValues)};

  double solution(std::size_t i) const { return std::sin(1.0 + static_cast<double>(i)); }

  explicit LinearIteration(double manual_radius = 0) {
    const shared::StepValues values{{0, 0, 0, 1}, {static_cast<float>(manual_radius), 0, 0, 0}, {}, {}};
    step.upload(0, sizeof values, &values);
  }
  /// Replaces x by A x + b and returns the error |x - x*| before.
  double sweep() {
    std::vector<vec4> x = displacement.read<vec4>();
    double error = 0;
    for (std::size_t i = 0; i < factor.size(); ++i) {
      float& value = (&x[i / 3].x)[i % 3];
      error += std::pow(value - solution(i), 2);
      value = static_cast<float>(factor[i] * value + (1 - factor[i]) * solution(i));
    }
    displacement.upload(0, x.size() * sizeof(vec4), x.data());
    return std::sqrt(error);
  }
  double first_error() const {
    double error = 0;
    for (std::size_t i = 0; i < factor.size(); ++i) error += solution(i) * solution(i);
    return std::sqrt(error);
  }
  /// Relative errors after 0, 1, ... iterations of the sweep and the acceleration.
  template <class Acceleration, class Begin = std::vector<gl::ComputePass> (*)()>
  std::vector<double> run(
      int iterations, Acceleration&& passes, Begin&& begin = [] { return std::vector<gl::ComputePass>(); }) {
    const std::vector<vec4> zero(kVertices);
    displacement.upload(0, 16 * kVertices, zero.data());
    start.upload(0, 16 * kVertices, zero.data());
    std::vector<double> errors;
    for (const gl::ComputePass& pass : begin()) pass.run();
    for (int k = 0; k <= iterations; ++k) {
      errors.push_back(sweep() / first_error());
      for (const gl::ComputePass& pass : passes(k == 0)) pass.run();
    }
    return errors;
  }
};

std::vector<double> chebyshev_run(Gpu& gpu, LinearIteration& problem, Chebyshev& chebyshev, int iterations) {
  return problem.run(iterations, [&](bool first) {
    return chebyshev.passes(gpu.programs, problem.step, problem.start, problem.displacement, first);
  });
}

}  // namespace

TEST_CASE("Anderson solves a linear problem of m different factors in m + 1 iterations", "[gpu]") {
  // On linear problems it is equivalent to GMRES (Walker and Ni 2011), whose polynomial of degree m has a root at every
  // factor.
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  Gpu gpu(loads);
  const int m = GENERATE(1, 2, 3);
  LinearIteration problem;
  const double factors[] = {0.9, -0.5, 0.4};
  for (std::size_t i = 0; i < problem.factor.size(); ++i) problem.factor[i] = factors[i % static_cast<std::size_t>(m)];
  // In one part or two, weighted or not, the solution and the number of iterations are the same.
  const bool two_parts = GENERATE(false, true);
  gl::Buffer second{"second", 16 * kVertices};
  const gl::Buffer weight{"weight", std::vector<float>(kVertices, 3.0f)};
  std::vector<AndersonPart> parts{{&problem.displacement, kVertices, two_parts ? &weight : nullptr}};
  if (two_parts) parts.push_back({&second, kVertices, &weight});
  const Anderson anderson(gpu.programs, parts, 5);
  const auto errors = problem.run(
      m + 1, [&](bool first) { return anderson.passes(gpu.programs, first); },
      [&] { return anderson.begin(gpu.programs); });
  CAPTURE(gl::name_of(loads), m, errors);
  CHECK(errors[static_cast<std::size_t>(m)] > 1e-3);  // not before
  // Exact up to the regularization of 1e-6 and the rounding of the dot products, times the condition of nearly parallel
  // columns.
  CHECK(errors[static_cast<std::size_t>(m) + 1] < 0.02 * errors[static_cast<std::size_t>(m)]);
}

TEST_CASE("a window that is too small still converges, more slowly", "[gpu]") {
  Gpu gpu;
  LinearIteration problem;
  for (std::size_t i = 0; i < problem.factor.size(); ++i)
    problem.factor[i] = 0.98 * static_cast<double>(i) / static_cast<double>(problem.factor.size());
  std::vector<double> last;
  for (const int window : {1, 3, 10}) {
    const Anderson anderson(gpu.programs, {{&problem.displacement, kVertices, nullptr}}, window);
    last.push_back(problem
                       .run(
                           20, [&](bool first) { return anderson.passes(gpu.programs, first); },
                           [&] { return anderson.begin(gpu.programs); })
                       .back());
  }
  const double plain = problem.run(20, [](bool) { return std::vector<gl::ComputePass>(); }).back();
  CAPTURE(last, plain);
  CHECK(last[0] < 0.5 * plain);
  CHECK(last[1] < 0.5 * last[0]);
  CHECK(last[2] < 0.7 * last[1]);  // ten columns are too nearly parallel for an equal gain in float32
}

TEST_CASE("Chebyshev with the true spectral radius shrinks errors as fast as its polynomial", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  Gpu gpu(loads);
  const double rho = GENERATE(0.5, 0.9, 0.98);
  LinearIteration problem(rho);
  for (std::size_t i = 0; i < problem.factor.size(); ++i)  // from -rho to rho
    problem.factor[i] = rho * (2.0 * static_cast<double>(i) / static_cast<double>(problem.factor.size() - 1) - 1);
  Chebyshev chebyshev(gpu.programs, kVertices);
  const int plain = 4, iterations = 40;
  const auto errors = chebyshev_run(gpu, problem, chebyshev, iterations);
  CAPTURE(gl::name_of(loads), rho, errors);
  // T_p(x / rho) / T_p(1 / rho) is at most 1 / T_p(1 / rho) over the spectrum; the plain iterations before multiply by
  // rho^plain at most.
  for (int p = 1; p <= iterations - plain; ++p) {
    const double bound = std::pow(rho, plain - 1) / std::cosh(p * std::acosh(1 / rho));
    CAPTURE(p, bound);
    CHECK(errors[static_cast<std::size_t>(p + plain - 1)] <= bound + 1e-6);
  }
}

TEST_CASE("the spectral radius is found from the decay of the residual", "[gpu]") {
  Gpu gpu;
  const double rho = GENERATE(0.8, 0.95, 0.99);
  LinearIteration problem;
  for (std::size_t i = 0; i < problem.factor.size(); ++i)
    problem.factor[i] = rho * (2.0 * static_cast<double>(i) / static_cast<double>(problem.factor.size() - 1) - 1);
  Chebyshev chebyshev(gpu.programs, kVertices);
  const double first = [&] {
    chebyshev_run(gpu, problem, chebyshev, 3);
    return chebyshev.spectral_radius();
  }();
  const int iterations = 60;
  const auto errors = chebyshev_run(gpu, problem, chebyshev, iterations);
  const double found = chebyshev.spectral_radius();
  const double plain = problem.run(iterations, [](bool) { return std::vector<gl::ComputePass>(); }).back();
  CAPTURE(rho, first, found, errors.back(), plain);
  CHECK(found > 1 - 2 * (1 - rho));
  CHECK(found < 1 - 0.5 * (1 - rho));
  CHECK(errors.back() < 0.3 * plain);
  chebyshev.forget_spectral_radius();
  CHECK(chebyshev.spectral_radius() == 0);
}

TEST_CASE("Chebyshev makes little more of a diverging iteration than plain iterations do", "[gpu]") {
  // Factors below -1 make plain iterations diverge, and accelerated ones far faster: T_p(1.3 / 0.99) / T_p(1 / 0.99) is
  // more than 1e6 times the 1.3^p of plain ones after 50. The safeguard ends a cycle when the residual has doubled;
  // four plain iterations come before each.
  Gpu gpu;
  LinearIteration problem(0.99);
  for (std::size_t i = 0; i < problem.factor.size(); ++i) problem.factor[i] = i % 7 == 0 ? -1.3 : 0.5;
  Chebyshev chebyshev(gpu.programs, kVertices);
  const int iterations = 50, cycles = iterations / 5;
  const auto errors = chebyshev_run(gpu, problem, chebyshev, iterations);
  const double plain = problem.run(iterations, [](bool) { return std::vector<gl::ComputePass>(); }).back();
  CAPTURE(errors, plain);
  CHECK(errors.back() < std::pow(2, cycles) * plain);  // false for NaN
}
