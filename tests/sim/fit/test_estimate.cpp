#include <catch2/catch.hpp>
#include <cmath>

#include "sim/fit/estimate.h"

namespace fascia {
namespace {

std::vector<Parameter> two_parameters() {
  std::vector<Parameter> parameters(2);
  parameters[0].key = "a";
  parameters[1].key = "b";
  parameters[1].logarithmic = false;
  return parameters;
}

// y = offset + slope x at x = -1, 0, 1 with residuals 1, -2, 1: the textbook's covariance is s^2 (J^T J)^-1.
TEST_CASE("intervals are those of linear regression", "[fit]") {
  FitNumbers numbers;
  numbers.inner = Eigen::Vector2d(std::log(3), 5);
  numbers.residuals = Eigen::Vector3d(1, -2, 1);
  numbers.rates.resize(3, 2);
  numbers.rates << 1, -1, 1, 0, 1, 1;
  const Estimates found = estimate(two_parameters(), numbers);
  const double s = std::sqrt(6.0), t = 12.706;  // one degree of freedom
  CHECK(found.spread == Approx(s));
  CHECK(found.parameters[0].value == Approx(3));
  CHECK(found.parameters[0].natural_error == Approx(s / std::sqrt(3.0)));
  CHECK(found.parameters[0].high == Approx(3 * std::exp(t * s / std::sqrt(3.0))).epsilon(1e-3));
  CHECK(found.parameters[1].low == Approx(5 - t * s / std::sqrt(2.0)).epsilon(1e-4));
  CHECK(found.correlation(0, 1) == Approx(0).margin(1e-12));
  CHECK(found.covariance(1, 1) == Approx(3));
  CHECK(found.determined());

  numbers.noise_known = true;
  const Estimates known = estimate(two_parameters(), numbers);
  CHECK(known.parameters[1].high == Approx(5 + 1.95996 / std::sqrt(2.0)).epsilon(1e-5));
  REQUIRE(known.warnings.size() == 1);
  CHECK(known.warnings[0] == "the residuals are 2.449 times the noise: the scene does not explain the measurement");
}

TEST_CASE("values without noise say nothing about the noise", "[fit]") {
  FitNumbers numbers;
  numbers.inner = Eigen::Vector2d(0, 0);
  numbers.residuals = Eigen::Vector3d(1, -2, 1);
  numbers.rates.resize(3, 2);
  numbers.rates << 1, -1, 1, 0, 1, 1;
  const Estimates without = estimate(two_parameters(), numbers);
  numbers.residuals.conservativeResizeLike(Eigen::VectorXd::Zero(5));
  numbers.rates.conservativeResizeLike(Eigen::MatrixXd::Zero(5, 2));
  const Estimates with = estimate(two_parameters(), numbers);
  CHECK(with.spread == without.spread);
  CHECK(with.parameters[0].high == Approx(without.parameters[0].high).epsilon(1e-12));

  numbers.residuals[3] = 0.5;  // noise where nothing changes
  CHECK(estimate(two_parameters(), numbers).spread == Approx(std::sqrt(6.25 / 2)));
}

TEST_CASE("as many values as parameters leave the noise unknown, and with it the intervals", "[fit]") {
  FitNumbers numbers;
  numbers.inner = Eigen::Vector2d(0, 0);
  numbers.residuals = Eigen::Vector2d(0, 0);
  numbers.rates = Eigen::Matrix2d::Identity();
  const Estimates found = estimate(two_parameters(), numbers);
  CHECK(found.determined());
  CHECK(std::isnan(found.parameters[0].low));
  CHECK(found.warnings == std::vector<std::string>{"as many values as parameters: no intervals without --noise"});
  numbers.noise_known = true;
  CHECK(estimate(two_parameters(), numbers).parameters[1].high == Approx(1.95996).epsilon(1e-5));
}

TEST_CASE("what is not determined is named, and nothing else", "[fit]") {
  FitNumbers numbers;
  numbers.measured = "the measurement (f)";
  numbers.inner = Eigen::Vector3d(0, 0, 0);
  numbers.residuals = Eigen::VectorXd::Constant(4, 1e-3);
  numbers.rates.resize(4, 3);
  numbers.rates << 1, -1, 0, 2, -2, 1, 3, -3, 0, 4, -4, 1;  // only a - b matters
  std::vector<Parameter> parameters = two_parameters();
  parameters.emplace_back().key = "c";
  const Estimates found = estimate(parameters, numbers);
  CHECK(!found.determined());
  CHECK(!found.parameters[0].determined);
  CHECK(!found.parameters[1].determined);
  CHECK(found.parameters[2].determined);
  CHECK(std::isinf(found.parameters[0].high));
  REQUIRE(!found.warnings.empty());
  CHECK(found.warnings[0] == "the measurement (f) alone cannot tell a from b");

  numbers.rates.col(1) = -numbers.rates.col(0) + 0.001 * Eigen::Vector4d(1, -1, 1, 1);
  const Estimates together = estimate(parameters, numbers);
  CHECK(together.determined());
  REQUIRE(!together.warnings.empty());
  CHECK(together.warnings.back().starts_with("a and b are known only together: correlation "));
}

TEST_CASE("rates below the rounding of the values determine nothing", "[fit]") {
  FitNumbers numbers;
  numbers.measured = "the measurement (f)";
  numbers.inner = Eigen::VectorXd::Zero(1);
  numbers.residuals = Eigen::Vector2d(1, -1);
  numbers.rates = Eigen::Vector2d(1e-8, 2e-8);
  const std::vector<Parameter> parameters{two_parameters().front()};
  CHECK(estimate(parameters, numbers).determined());
  numbers.magnitude = 100;
  const Estimates found = estimate(parameters, numbers);
  CHECK(!found.determined());
  REQUIRE(!found.warnings.empty());
  CHECK(found.warnings[0] == "the measurement (f) does not depend on a");
}

TEST_CASE("a value at its bound is named", "[fit]") {
  std::vector<Parameter> parameters(1);
  parameters[0].key = "nu";
  parameters[0].logarithmic = false;
  parameters[0].bounds = {0, 0.5};
  const FitNumbers numbers{Eigen::VectorXd::Constant(1, 9),
                           Eigen::Vector2d(1, -1),
                           Eigen::MatrixXd::Constant(2, 1, 1),
                           false,
                           0,
                           "the measurement (f)"};
  const Estimates found = estimate(parameters, numbers);
  CHECK(found.parameters[0].high <= 0.5);
  REQUIRE(!found.warnings.empty());
  CHECK(found.warnings[0] == "nu is at its bound 0.5");
}

}  // namespace
}  // namespace fascia
