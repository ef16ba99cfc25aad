// What a fit says about its parameters at the minimum, to first order: intervals, correlations, and what the
// measurement does not determine.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "sim/fit/parameter.h"

namespace fascia {

struct Estimate {
  std::string key;
  double value = 0;
  double low = 0, high = 0;  // interval that holds the true value with a probability of 95 %; NaN: unknown noise
  double natural_error = 0;  // standard error in the natural coordinate
  bool determined = true;    // by the measurement; else low and high are infinite
};

struct Estimates {
  std::vector<Estimate> parameters;
  Eigen::MatrixXd covariance;   // of the inner coordinates
  Eigen::MatrixXd cofactors;    // the same for a spread of 1
  Eigen::MatrixXd correlation;  // [parameter][parameter] of the natural coordinates
  double spread = 1;            // root mean square residual per degree of freedom; 1 where the noise is known to fit
  std::vector<std::string> warnings;
  bool determined() const;
};

struct FitNumbers {
  Eigen::VectorXd inner;      // [parameter]
  Eigen::VectorXd residuals;  // weighted by the noise
  Eigen::MatrixXd rates;      // d residuals/d inner
  bool noise_known = false;   // else it is estimated from the residuals, and intervals are those of Student's t
  double magnitude = 0;  // of the values that the residuals compare, in the same weights: smaller rates are rounding
  std::string measured;  // subject of warnings: "the measurement (reaction_y)"
};
Estimates estimate(const std::vector<Parameter>& parameters, const FitNumbers& numbers);

}  // namespace fascia
