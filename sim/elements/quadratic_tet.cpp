#include "sim/elements/quadratic_tet.h"

#include "sim/mesh/tet_mesh.h"

namespace fascia {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;

QuadraticTet::ShapeFunctions QuadraticTet::shape_functions(const Barycentric& l) {
  return shape_functions(l, Barycentric::Zero());
}

QuadraticTet::ShapeFunctions QuadraticTet::shape_functions(const Barycentric& l, const Barycentric& d) {
  ShapeFunctions n;
  for (int a = 0; a < 4; ++a) n[a] = l[a] * (2 * l[a] - 1) + (4 * l[a] - 1) * d[a];
  for (std::size_t m = 0; m < 6; ++m) {
    const auto [a, b] = kMidEdgeCorners[m];
    n[4 + m] = 4 * (l[a] * l[b] + l[a] * d[b] + d[a] * l[b]);
  }
  return n;
}

QuadraticTet::ShapeGradients QuadraticTet::shape_gradients(const Vector4d& l) const {
  ShapeGradients shape;
  for (int a = 0; a < 4; ++a) shape.col(a) = (4 * l[a] - 1) * gradients.col(a);
  for (int m = 0; m < 6; ++m) {
    const auto a = static_cast<int>(kMidEdgeCorners[m][0]), b = static_cast<int>(kMidEdgeCorners[m][1]);
    shape.col(4 + m) = 4 * (l[a] * gradients.col(b) + l[b] * gradients.col(a));
  }
  return shape;
}

const std::vector<QuadraticTet::Barycentric>& QuadraticTet::points() {
  static const std::vector<Barycentric> all = [] {
    std::vector<Barycentric> points(kPoints, Barycentric::Constant(kFar));
    for (int q = 0; q < kPoints; ++q) points[static_cast<std::size_t>(q)][q] = kNear;
    return points;
  }();
  return all;
}

QuadraticTet::ShapeGradients QuadraticTet::shape_gradients_at_point(int q) const {
  return shape_gradients(points()[static_cast<std::size_t>(q)]);
}

// Corner c has L_c = 1: with b the other corners and cb the middle of the edge to b,
//   H_c = 3 u_c g_c^T + sum_b (4 u_cb - u_b) g_b^T = sum_b (4 (u_cb - u_c) - (u_b - u_c)) g_b^T
// since the gradients of all shape functions add up to zero.
QuadraticTet::PointGradients QuadraticTet::at_corners(const Nodes& u) const {
  PointGradients h;
  for (int c = 0; c < 4; ++c) {
    h[c].setZero();
    for (int m = 0; m < 6; ++m) {
      const auto a = static_cast<int>(kMidEdgeCorners[m][0]), b = static_cast<int>(kMidEdgeCorners[m][1]);
      if (a != c && b != c) continue;
      const int other = a == c ? b : a;
      h[c] += (4 * (u[4 + m] - u[c]) - (u[other] - u[c])) * gradients.col(other).transpose();
    }
  }
  return h;
}

QuadraticTet::PointGradients QuadraticTet::at_points(const Nodes& u) const {
  PointGradients h = at_corners(u);
  const Matrix3d far = kFar * (h[0] + h[1] + h[2] + h[3]);
  for (Matrix3d& at : h) at = far + (kNear - kFar) * at;
  return h;
}

Matrix3d QuadraticTet::at_centroid(const Nodes& u) const {
  const PointGradients h = at_corners(u);
  return 0.25 * (h[0] + h[1] + h[2] + h[3]);
}

}  // namespace fascia
