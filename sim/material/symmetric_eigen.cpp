#include "sim/material/symmetric_eigen.h"

#include <Eigen/Eigenvalues>

namespace fascia {

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& a) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(a);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(a, b);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

}  // namespace fascia
