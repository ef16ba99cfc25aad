// The linear tet on affine displacements, which it represents exactly.
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "sim/elements/linear_tet.h"

using namespace fascia;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

const Corners kCorners = {Vector3d(0.1, 0.2, -0.1), Vector3d(1.3, 0.1, 0.2), Vector3d(0.3, 0.9, 0.1),
                          Vector3d(0.2, 0.4, 1.1)};

Corners moved(const Matrix3d& f, const Vector3d& by) {
  Corners u;
  for (std::size_t a = 0; a < 4; ++a) u[a] = f * kCorners[a] + by - kCorners[a];
  return u;
}

}  // namespace

TEST_CASE("a linear tet has the volume of its corners, and gradients of shape functions that sum to zero") {
  const LinearTet tet(kCorners);
  Matrix3d edges;
  edges << kCorners[1] - kCorners[0], kCorners[2] - kCorners[0], kCorners[3] - kCorners[0];
  CHECK(tet.volume == Approx(edges.determinant() / 6).epsilon(1e-14));
  CHECK(tet.gradients.rowwise().sum().norm() < 1e-15);
  for (int a = 0; a < 4; ++a)
    for (std::size_t b = 1; b < 4; ++b) {
      CAPTURE(a, b);  // the change of shape function a from corner 0 to corner b
      const double rise = tet.gradients.col(a).dot(kCorners[b] - kCorners[0]);
      CHECK(rise == Approx((static_cast<std::size_t>(a) == b) - (a == 0)).margin(1e-14));
    }
}

TEST_CASE("a linear tet returns the F of an affine map") {
  Matrix3d f;
  f << 1.2, 0.3, -0.1, 0.05, 0.8, 0.2, -0.3, 0.1, 1.1;
  const Matrix3d found = LinearTet(kCorners).deformation_gradient(moved(f, {3, -2, 5}));
  CAPTURE(found, f);
  CHECK((found - f).norm() < 1e-14);
}

TEST_CASE("the displacement gradient keeps the digits of small displacements under a large translation") {
  Matrix3d h = Matrix3d::Zero();
  h(0, 1) = 1e-9;
  Corners u;
  for (std::size_t a = 0; a < 4; ++a) u[a] = h * kCorners[a];
  const LinearTet tet(kCorners);
  CHECK((tet.displacement_gradient(u) - h).norm() < 1e-15 * 1e-9 * 10);
  CHECK(tet.deformation_gradient(u) == Matrix3d::Identity() + tet.displacement_gradient(u));
}
