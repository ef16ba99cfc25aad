// Chebyshev and Anderson acceleration of a fixed-point iteration in double precision, from their definitions: the
// reference for the GPU passes, and for linear problems with known solutions.
#pragma once
#include <Eigen/Core>
#include <deque>

namespace fascia::reference {

/// x_{k+1} = G(x_k) - dG theta with theta = argmin |f_k - dF theta|, f = G(x) - x (Peng et al. 2018).
class DoubleAnderson {
 public:
  explicit DoubleAnderson(int window) : window_(static_cast<std::size_t>(window)) {}
  /// x_{k+1} from x_k and G(x_k).
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& g);

 private:
  std::size_t window_;
  std::deque<Eigen::VectorXd> df_, dg_;
  Eigen::VectorXd f_, g_;
};

/// x_{k+1} = omega (G(x_k) - x_{k-1}) + x_{k-1} (Wang 2015), rho given or estimated after Hageman and Young 1981.
class DoubleChebyshev {
 public:
  explicit DoubleChebyshev(double manual_radius) : manual_(manual_radius) {}
  void begin_step();  // the estimate is kept
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& g);
  double radius() const { return manual_ > 0 ? manual_ : radius_; }

 private:
  double manual_, radius_ = 0, omega_ = 1, begin_ = 0, last_ = 0, first_ = 0;
  int iteration_ = 0, count_ = 0;
  Eigen::VectorXd before_;
};

}  // namespace fascia::reference
