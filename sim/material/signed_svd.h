// Singular values that carry the sign of the determinant.
#pragma once
#include <Eigen/Core>

namespace fascia {

/// F = U diag(s) V^T with det U = det V = 1 and |s| descending: the last one carries the sign of det F.
struct SignedSvd {
  Eigen::Matrix3d u, v;
  Eigen::Vector3d s;
};
SignedSvd signed_svd(const Eigen::Matrix3d& f);

}  // namespace fascia
