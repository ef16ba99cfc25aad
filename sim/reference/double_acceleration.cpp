#include "sim/reference/double_acceleration.h"

#include <algorithm>
#include <cmath>

namespace fascia::reference {

Eigen::VectorXd DoubleAnderson::next(const Eigen::VectorXd& x, const Eigen::VectorXd& g) {
  const Eigen::VectorXd f = g - x;
  const bool first = f_.size() == 0;
  if (!first) {
    df_.push_back(f - f_);
    dg_.push_back(g - g_);
    if (df_.size() > window_) {
      df_.pop_front();
      dg_.pop_front();
    }
    if (f.squaredNorm() > 4 * f_.squaredNorm()) {
      df_.clear();
      dg_.clear();
    }
  }
  f_ = f;
  g_ = g;
  Eigen::VectorXd result = g;
  if (df_.empty()) return result;
  const auto n = static_cast<Eigen::Index>(df_.size());
  Eigen::MatrixXd unit(f.size(), n);  // columns of dF scaled to length 1
  Eigen::VectorXd scale(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const double length = df_[static_cast<std::size_t>(j)].norm();
    scale[j] = length > 0 ? 1 / length : 0;
    unit.col(j) = scale[j] * df_[static_cast<std::size_t>(j)];
  }
  Eigen::MatrixXd normal = unit.transpose() * unit;
  normal.diagonal().setConstant(1 + 1e-6);
  const Eigen::VectorXd theta = scale.asDiagonal() * normal.ldlt().solve(unit.transpose() * f);
  for (Eigen::Index j = 0; j < n; ++j) result -= theta[j] * dg_[static_cast<std::size_t>(j)];
  return result;
}

void DoubleChebyshev::begin_step() {
  iteration_ = 0;
  before_.resize(0);
}

Eigen::VectorXd DoubleChebyshev::next(const Eigen::VectorXd& x, const Eigen::VectorXd& g) {
  constexpr int kPlain = 4, kShortest = 4;
  const double norm = (g - x).norm();
  double rho = radius();
  if (iteration_ == 0) {
    count_ = -kPlain + 1;
    first_ = norm;
  } else if (count_ < 0) {
    if (++count_ == 0) {
      if (rho == 0 && last_ > 0) rho = std::clamp(norm / last_, 0.1, 0.9995);
      begin_ = norm;
    }
  } else if (norm > 2 * begin_) {
    count_ = -kPlain + 1;
    rho = std::max(1 - 2 * (1 - rho), 0.1);
  } else {
    ++count_;
    if (count_ >= kShortest && norm > 1e-4 * first_ && manual_ == 0) {
      const double s = std::sqrt(1 - rho * rho), r = (1 - s) / (1 + s), rp = std::pow(r, count_);
      const double expected = 1 / std::cosh(count_ * std::acosh(1 / rho)), reached = norm / begin_;
      if (reached > std::pow(expected, 0.75)) {
        const double b = std::min(reached, 1.0);
        const double root =
            std::pow(0.5 * (1 + rp) * (b + std::sqrt(std::max(b * b - expected * expected, 0.0))), 1.0 / count_);
        const double better = std::min((root * root + r) / ((1 + r) * root), 0.9995);
        if (better > rho) {
          rho = better;
          count_ = 0;
          begin_ = norm;
        }
      }
    }
  }
  omega_ = count_ <= 0 ? 1 : count_ == 1 ? 2 / (2 - rho * rho) : 4 / (4 - rho * rho * omega_);
  radius_ = rho;
  last_ = norm;
  const Eigen::VectorXd result = omega_ == 1 ? g : Eigen::VectorXd(omega_ * (g - before_) + before_);
  before_ = x;
  ++iteration_;
  return result;
}

}  // namespace fascia::reference
