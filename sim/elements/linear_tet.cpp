#include "sim/elements/linear_tet.h"

#include <Eigen/LU>

namespace fascia {

using Eigen::Matrix3d;

LinearTet::LinearTet(const Corners& x) {
  Matrix3d edges;
  edges << x[1] - x[0], x[2] - x[0], x[3] - x[0];
  gradients.rightCols<3>() = edges.inverse().transpose();
  gradients.col(0) = -gradients.rightCols<3>().rowwise().sum();
  volume = edges.determinant() / 6;
}

Matrix3d LinearTet::displacement_gradient(const Corners& u) const {
  Matrix3d h = Matrix3d::Zero();
  for (int a = 1; a < 4; ++a) h += (u[a] - u[0]) * gradients.col(a).transpose();
  return h;
}

Matrix3d LinearTet::deformation_gradient(const Corners& u) const {
  return Matrix3d::Identity() + displacement_gradient(u);
}

}  // namespace fascia
