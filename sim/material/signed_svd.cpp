#include "sim/material/signed_svd.h"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace fascia {

using Eigen::Matrix3d;

SignedSvd signed_svd(const Matrix3d& f) {
  const Eigen::JacobiSVD<Matrix3d> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
  SignedSvd result{svd.matrixU(), svd.matrixV(), svd.singularValues()};
  for (Matrix3d* m : {&result.u, &result.v})
    if (m->determinant() < 0) {
      m->col(2) *= -1;
      result.s[2] *= -1;
    }
  return result;
}

}  // namespace fascia
