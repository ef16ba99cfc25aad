#include "sim/fit/estimate.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/suggest.h"
#include "base/text.h"
#include "sim/fit/student.h"

namespace fascia {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Below this share of the values, or of the largest singular value, differences of two simulations are rounding.
constexpr double kSingular = 1e-6;
// Of a direction: smaller components do not belong to what it mixes.
constexpr double kPart = 0.2;
constexpr double kStrong = 0.99;  // correlation
constexpr double kWide = 2;       // an interval of half this factor or more in the logarithm says nothing: e^2 = 7.4

std::string keys_of(const VectorXd& direction, const std::vector<Parameter>& parameters) {
  std::string keys;
  for (Index p = 0; p < direction.size(); ++p)
    if (std::abs(direction[p]) > kPart)
      keys += (keys.empty() ? "" : " from ") + parameters[static_cast<std::size_t>(p)].key;
  return keys;
}

// Values that are what they must be, such as the zeros of a history at time 0: they carry no noise.
Index certain_values(const FitNumbers& numbers) {
  Index count = 0;
  for (Index row = 0; row < numbers.residuals.size(); ++row)
    count += numbers.residuals[row] == 0 && numbers.rates.row(row).isZero(0);
  return count;
}

bool is_one_key(const VectorXd& direction) { return (direction.array().abs() > kPart).count() == 1; }

}  // namespace

bool Estimates::determined() const {
  return std::all_of(parameters.begin(), parameters.end(), [](const Estimate& e) { return e.determined; });
}

Estimates estimate(const std::vector<Parameter>& parameters, const FitNumbers& numbers) {
  const Index count = numbers.inner.size(), freedom = numbers.residuals.size() - certain_values(numbers) - count;
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  Estimates result;
  VectorXd natural_rate(count);
  for (Index p = 0; p < count; ++p)
    natural_rate[p] = parameters[static_cast<std::size_t>(p)].natural_rate(numbers.inner[p]);
  const MatrixXd rates = numbers.rates * natural_rate.cwiseInverse().asDiagonal();
  const Eigen::JacobiSVD<MatrixXd> svd(rates, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const double least = kSingular * std::max(svd.singularValues()[0], numbers.magnitude);

  // As many values as parameters leave no residual to estimate the noise from.
  const double spread = freedom > 0 ? std::sqrt(numbers.residuals.squaredNorm() / static_cast<double>(freedom))
                                    : std::numeric_limits<double>::quiet_NaN();
  result.spread = numbers.noise_known ? 1 : spread;
  const double quantile = student_95(numbers.noise_known || freedom < 1 ? kInfinite : static_cast<double>(freedom));
  MatrixXd cofactors = MatrixXd::Zero(count, count);
  VectorXd lost = VectorXd::Zero(count);  // how much of a parameter the measurement does not determine
  for (Index k = 0; k < count; ++k) {
    const VectorXd direction = svd.matrixV().col(k);
    const double value = svd.singularValues()[k];
    if (!(value > least)) {
      lost = lost.cwiseMax(direction.cwiseAbs());
      result.warnings.push_back(is_one_key(direction)
                                    ? numbers.measured + " does not depend on " + keys_of(direction, parameters)
                                    : numbers.measured + " alone cannot tell " + keys_of(direction, parameters));
      continue;
    }
    cofactors += direction * direction.transpose() / (value * value);
  }
  if (!numbers.noise_known && freedom < 1)
    result.warnings.push_back("as many values as parameters: no intervals without --noise");
  const VectorXd unit_errors = cofactors.diagonal().cwiseSqrt(), errors = result.spread * unit_errors;
  result.correlation = MatrixXd::Identity(count, count);
  for (Index a = 0; a < count; ++a)
    for (Index b = 0; b < count; ++b)
      if (a != b && unit_errors[a] > 0 && unit_errors[b] > 0)
        result.correlation(a, b) = cofactors(a, b) / (unit_errors[a] * unit_errors[b]);
  const MatrixXd inner_of = natural_rate.cwiseInverse().asDiagonal();
  result.cofactors = inner_of * cofactors * inner_of;
  result.covariance = result.spread * result.spread * result.cofactors;

  for (Index p = 0; p < count; ++p) {
    const Parameter& parameter = parameters[static_cast<std::size_t>(p)];
    Estimate& estimate = result.parameters.emplace_back();
    estimate.key = parameter.key;
    estimate.value = parameter.value(numbers.inner[p]);
    estimate.natural_error = errors[p];
    estimate.determined = lost[p] <= kPart;
    if (!estimate.determined) {
      estimate.low = parameter.bounds ? parameter.bounds->low : parameter.logarithmic ? 0 : -kInfinite;
      estimate.high = parameter.bounds ? parameter.bounds->high : kInfinite;
      estimate.natural_error = kInfinite;
      continue;
    }
    const double middle = parameter.natural(estimate.value), half = quantile * errors[p];
    estimate.low = parameter.from_natural(middle - half);
    estimate.high = parameter.from_natural(middle + half);
    if (parameter.bounds) {
      estimate.low = std::max(estimate.low, parameter.bounds->low);
      estimate.high = std::min(estimate.high, parameter.bounds->high);
      const double share = (middle - parameter.natural(parameter.bounds->low)) /
                           (parameter.natural(parameter.bounds->high) - parameter.natural(parameter.bounds->low));
      constexpr double kAtBound = 1e-3;
      if (share < kAtBound || share > 1 - kAtBound)
        result.warnings.push_back(parameter.key + " is at its bound " +
                                  number(share < 0.5 ? parameter.bounds->low : parameter.bounds->high));
    }
    if (parameter.logarithmic && half > kWide)
      result.warnings.push_back(numbers.measured + " hardly determines " + parameter.key + ": " + number(estimate.low) +
                                " to " + number(estimate.high));
  }
  for (Index a = 0; a < count; ++a)
    for (Index b = a + 1; b < count; ++b)
      if (std::abs(result.correlation(a, b)) > kStrong && lost[a] <= kPart && lost[b] <= kPart)
        result.warnings.push_back(parameters[static_cast<std::size_t>(a)].key + " and " +
                                  parameters[static_cast<std::size_t>(b)].key +
                                  " are known only together: correlation " + number(result.correlation(a, b)));
  constexpr double kPoor = 2;
  if (numbers.noise_known && spread > kPoor)
    result.warnings.push_back("the residuals are " + number(spread) +
                              " times the noise: the scene does not explain the measurement");
  return result;
}

}  // namespace fascia
