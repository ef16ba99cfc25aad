// Errors in time from motions whose dependence on the length of steps is known.
#include "sim/accuracy/time_extrapolation.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

using namespace fascia;
using Eigen::Vector3d;

namespace {

constexpr int kMoments = 10;
constexpr double kDisplacement = 2, kStress = 300;

// Two vertices that move by the displacement and an error in another direction, which grows along the motion.
Trajectory motion_with(double error) {
  Trajectory motion;
  for (int moment = 1; moment <= kMoments; ++moment) {
    const double here = error * moment / kMoments;
    motion.displacement.push_back({{kDisplacement, here, 0}, {0, kDisplacement, -here}});
  }
  motion.peak_stress = kStress * (1 + error);
  return motion;
}

// Errors of steps of length 1, 1/2, ...
TimeError estimate(int order, const std::function<double(double)>& error, int* motions = nullptr) {
  TimeExtrapolation extrapolation(order);
  int count = 0;
  for (; extrapolation.wants_more(); ++count) extrapolation.add(motion_with(error(std::pow(0.5, count))));
  if (motions) *motions = count;
  return extrapolation.error();
}

}  // namespace

TEST_CASE("an error that falls with a power of the step is found, the power too") {
  const double order = GENERATE(0.6, 1.0, 1.5, 2.0);
  CAPTURE(order);
  int motions = 0;
  const TimeError error = estimate(
      2, [&](double h) { return 0.1 * std::pow(h, order); }, &motions);
  CHECK(motions == 3);
  CHECK(error.resolved);
  CHECK(error.order == Approx(order));
  CHECK(error.relative == Approx(0.1 / kDisplacement));
  double squares = 0;
  for (int moment = 1; moment <= kMoments; ++moment) squares += moment * moment;
  CHECK(error.over_run == Approx(0.1 / kDisplacement * std::sqrt(squares / kMoments) / kMoments));
  CHECK(error.peak_stress == Approx(0.1));
}

TEST_CASE("an error that falls faster than the integrator's order is not taken for smaller by that") {
  const TimeError error = estimate(1, [](double h) { return 0.1 * h * h; });
  CHECK(error.resolved);
  CHECK(error.order == 1);
  CHECK(error.relative == Approx((0.1 * (1 - 1.0 / 16) + 0.1 * (1.0 / 4 - 1.0 / 16)) / kDisplacement).epsilon(1e-3));
}

TEST_CASE("an error that hardly falls is a bound of the differences, after four motions") {
  const double rate = GENERATE(0.8, 1.0, 1.5);  // of the differences from halving to halving
  CAPTURE(rate);
  const auto error_of = [&](double h) {
    double sum = 0;
    for (int k = 0; k < std::lround(-std::log2(h)); ++k) sum += 0.1 * std::pow(rate, k);
    return sum;
  };
  int motions = 0;
  const TimeError error = estimate(2, error_of, &motions);
  CHECK(motions == 4);
  CHECK_FALSE(error.resolved);
  CHECK(error.order == Approx(std::max(0.0, -std::log2(rate))));
  const double changes = 0.1 * (1 + rate + rate * rate), last = 0.1 * rate * rate;
  CHECK(error.relative == Approx((changes + (1 + std::sqrt(2)) * last) / kDisplacement).epsilon(0.1));
  CHECK(error.peak_stress > changes / (1 + changes));
}

TEST_CASE("a witness far from the motion on which all steps agree makes the error a bound") {
  const double away = GENERATE(0.15, 0.5);
  CAPTURE(away);
  TimeExtrapolation extrapolation(1);
  for (const double h : {1.0, 0.5, 0.25}) extrapolation.add(motion_with(0.1 * h));
  const double alone = extrapolation.error().relative;
  extrapolation.add_witness(motion_with(away));
  const TimeError error = extrapolation.error();
  const bool doubted = away > TimeExtrapolation::kFarthest * 0.1;
  CHECK(error.resolved == !doubted);
  CHECK(error.relative == Approx(doubted ? (away - 0.1) / kDisplacement : alone));
  CHECK(error.peak_stress == Approx(doubted ? away - 0.1 : 0.1));
}

TEST_CASE("a fourth motion decides where the first three hardly differ in their changes") {
  int motions = 0;
  // Changes 0.1, 0.1, 0.02: contact that short steps resolve.
  const TimeError error = estimate(
      2, [](double h) { return h == 1      ? 0.22
                               : h == 0.5  ? 0.12
                               : h == 0.25 ? 0.02
                                           : 0.0; }, &motions);
  CHECK(motions == 4);
  CHECK(error.resolved);
  CHECK(error.relative == Approx(0.22 / kDisplacement).epsilon(0.05));
}

TEST_CASE("a vibration that all long steps damp is a bound at the end from the run before") {
  TimeExtrapolation extrapolation(1);
  for (int count = 0; extrapolation.wants_more(); ++count) {
    Trajectory motion;
    for (int moment = 1; moment <= kMoments; ++moment)  // it lasts the longer, the shorter the steps are
      motion.displacement.push_back({{kDisplacement, std::exp2(-moment / std::exp2(count)) * (1 << count), 0}});
    for (Vector3d& u : motion.displacement.back()) u.y() = 0;
    extrapolation.add(std::move(motion));
  }
  const TimeError error = extrapolation.error();
  CHECK_FALSE(error.resolved);
  CHECK(error.relative >= 0.99 * error.over_run);
  CHECK(error.over_run > 1);
}

TEST_CASE("a motion that does not depend on its steps, or rounds off, has no error in time") {
  int motions = 0;
  const TimeError none = estimate(
                      2, [](double) { return 0.1; }, &motions),
                  rounded = estimate(2, [](double h) { return std::fmod(1e7 * h, 2) * 1e-7; });
  CHECK(motions == 3);
  CHECK(none.relative == 0);
  CHECK(none.over_run == 0);
  CHECK(none.peak_stress == 0);
  CHECK(none.resolved);
  CHECK(rounded.resolved);
  CHECK(rounded.relative < 1e-6);
}
