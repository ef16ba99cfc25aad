// The stages of every integrator on a linear oscillator, whose exact motion and whose damping per step are known.
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <functional>

#include "sim/integrators/integrator.h"

using namespace fascia;

namespace {

// u'' = -w^2 u + load, one vertex in one dimension.
struct Oscillator {
  double frequency, load = 0;  // w [1/s], [m/s^2]
  double u = 1, v = 0, earlier_u = 0, earlier_v = 0, earlier_step = 0;

  void step(Integrator integrator, double h) {
    for (const IntegratorStage& stage : stages_of(integrator, h, earlier_step)) {
      const double from = stage.extrapolated(u, earlier_u), speed = stage.extrapolated(v, earlier_v), l = stage.length;
      const double predicted = from + l * speed + l * l * load;
      earlier_u = u;
      earlier_v = v;
      u = predicted / (1 + l * l * frequency * frequency);
      v = (u - from) / l;
    }
    earlier_step = info_of(integrator).multistep ? h : 0;
  }
};

// Of the motion from u = 1 at rest over `time` with steps h(k) of a length near `h`.
double error_at_end(Integrator integrator, double time, double h, const std::function<double(int)>& variation) {
  constexpr double kFrequency = 3, kLoad = 2;
  Oscillator body{kFrequency, kLoad};
  double t = 0;
  for (int k = 0; t < time; ++k) {
    const double step = std::min(h * variation(k), time - t);
    body.step(integrator, step);
    t += step;
  }
  const double rest = kLoad / (kFrequency * kFrequency);
  return std::abs(body.u - (rest + (1 - rest) * std::cos(kFrequency * t)));
}

double even(int) { return 1; }
double uneven(int k) { return k % 3 == 0 ? 1.3 : k % 3 == 1 ? 0.6 : 1.1; }

}  // namespace

TEST_CASE("integrators have the order that they state, with even and uneven steps") {
  const auto [integrator, order] = GENERATE(
      table<Integrator, int>({{Integrator::implicit_euler, 1}, {Integrator::bdf2, 2}, {Integrator::sdirk2, 2}}));
  const auto variation = GENERATE(even, uneven);
  const double coarse = error_at_end(integrator, 2, 1e-3, variation),
               fine = error_at_end(integrator, 2, 2.5e-4, variation);
  CAPTURE(name_of(integrator), coarse, fine);
  CHECK(std::log(coarse / fine) / std::log(4) == Approx(order).margin(0.1));
}

TEST_CASE("integrators damp an oscillation by as much as theory says") {
  // exp(-2 pi z / sqrt(1 - z^2)) is the loss of amplitude in a period of damping ratio z. Known: implicit Euler's
  // amplification is 1/sqrt(1 + x^2), x = w h; that of BDF2 is the root of 3 r^2 - 4 r + 1 = 2 i x r^2 nearest to exp(i
  // x).
  const double x = GENERATE(0.1, 0.5, 1.0);
  constexpr int kSteps = 400;
  const auto measured = [&](Integrator integrator) {
    Oscillator body{x};
    const auto size = [&] { return std::hypot(body.u, body.v / x); };
    for (int k = 0; k < 50; ++k) body.step(integrator, 1);
    const double before = size();
    for (int k = 0; k < kSteps; ++k) body.step(integrator, 1);
    return std::pow(size() / before, 1.0 / kSteps);
  };
  using Complex = std::complex<double>;
  const Complex a(3, -2 * x), root = std::sqrt(Complex(16) - 4.0 * a);
  const double bdf2 = std::max(std::abs((4.0 + root) / (2.0 * a)), std::abs((4.0 - root) / (2.0 * a)));
  CAPTURE(x);
  CHECK(measured(Integrator::implicit_euler) == Approx(1 / std::sqrt(1 + x * x)).epsilon(1e-10));
  CHECK(measured(Integrator::bdf2) == Approx(bdf2).epsilon(1e-3));
  const double g = 1 - std::sqrt(0.5);
  const Complex z(0, x), sdirk2 = (1.0 + (1 - 2 * g) * z) / ((1.0 - g * z) * (1.0 - g * z));
  CHECK(measured(Integrator::sdirk2) == Approx(std::abs(sdirk2)).epsilon(1e-3));
}

TEST_CASE("a free fall is exact from the second step of BDF2 on, and at once with SDIRK2") {
  constexpr double kStep = 0.02, kGravity = -9.81;
  for (const Integrator integrator : {Integrator::bdf2, Integrator::sdirk2}) {
    CAPTURE(name_of(integrator));
    Oscillator body{0, kGravity, 0, 3};
    body.step(integrator, kStep);
    const double u = body.u, v = body.v;
    for (int k = 0; k < 5; ++k) body.step(integrator, kStep);
    const double t = 5 * kStep;
    CHECK(body.v == Approx(v + kGravity * t).epsilon(1e-12));
    if (integrator == Integrator::sdirk2) CHECK(body.u == Approx(u + v * t + kGravity * t * t / 2).epsilon(1e-12));
  }
}

TEST_CASE("BDF2 is implicit Euler without an earlier step, and after one that is much shorter") {
  for (const double earlier : {0.0, 0.004}) {
    const std::vector<IntegratorStage> stages = stages_of(Integrator::bdf2, 0.01, earlier);
    REQUIRE(stages.size() == 1);
    CAPTURE(earlier, stages[0].length, stages[0].extrapolation);
    CHECK(stages[0] == IntegratorStage{0.01});
  }
  const IntegratorStage equal = stages_of(Integrator::bdf2, 0.01, 0.01)[0];
  CHECK(equal.length == Approx(0.02 / 3).epsilon(1e-14));
  CHECK(equal.extrapolation == Approx(1.0 / 3).epsilon(1e-14));
  CHECK(equal.duration == 0.01);
}

TEST_CASE("the stages of a substep fill it") {
  for (const IntegratorInfo& info : integrators()) {
    CAPTURE(info.name);
    const std::vector<IntegratorStage> stages = stages_of(info.integrator, 0.03, 0.02);
    CHECK(static_cast<int>(stages.size()) == info.stages);
    double t = 0;
    for (const IntegratorStage& stage : stages) {
      t += stage.duration;
      CHECK((stage.extrapolation == 0 || info.extrapolates));
    }
    CHECK(t == Approx(0.03).epsilon(1e-14));
    CHECK(find_integrator(info.name) == info.integrator);
  }
  CHECK_FALSE(find_integrator("euler"));
}
