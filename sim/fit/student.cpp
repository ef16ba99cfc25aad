#include "sim/fit/student.h"

#include <Eigen/Core>
#include <cmath>
#include <unsupported/Eigen/SpecialFunctions>

namespace fascia {

// P(|T| > t) = I_{nu / (nu + t^2)}(nu / 2, 1 / 2) (Abramowitz, Stegun 1964, 26.7.1), solved by bisection.
double student_95(double degrees_of_freedom) {
  constexpr double kNormal = 1.959963984540054;
  if (!(degrees_of_freedom < 1e6)) return kNormal;
  double low = 1, high = 13;  // from infinite degrees of freedom to one
  while (high - low > 1e-10) {
    const double t = 0.5 * (low + high), nu = degrees_of_freedom;
    const double outside = Eigen::numext::betainc(0.5 * nu, 0.5, nu / (nu + t * t));
    (outside > 0.05 ? low : high) = t;
  }
  return 0.5 * (low + high);
}

}  // namespace fascia
