// Eigenvalues of symmetric matrices of run-time size, in double precision. One file has Eigen's decomposition: it takes
// ten seconds to compile, wherever it is used.
#pragma once
#include <Eigen/Core>

namespace fascia {

struct SymmetricEigen {
  Eigen::VectorXd values;   // [n] ascending
  Eigen::MatrixXd vectors;  // [n x n] one per column
};

/// A v = value v with orthonormal v. Reads the lower triangle of `a` [n x n].
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& a);

/// A v = value B v with v^T B v = 1, for a positive definite `b` [n x n].
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace fascia
