// Singular values with the sign of the determinant, of matrices whose singular values are known.
#include "sim/material/signed_svd.h"

#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>

#include "tests/sim/reference/box_model.h"

using namespace fascia;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::Random;

namespace {

/// Descending by size, with the sign of their product at the last one.
Vector3d sorted(const Vector3d& s) {
  Vector3d sizes = s.cwiseAbs();
  std::sort(sizes.data(), sizes.data() + 3, std::greater<>());
  if (s.prod() < 0) sizes[2] *= -1;
  return sizes;
}

}  // namespace

TEST_CASE("signed singular values give the matrix back with proper rotations") {
  Random random(11);
  const std::vector<Vector3d> all = {{1.1, 0.9, 0.8},    {1.2, 0.9, 0.0}, {1.1, 1.0, -0.5}, {0.31, 0.3, 0.2999},
                                     {0.5, 0.45, -0.35}, {1.0, 0.5, 0.5}, {0, 0, 0},        {1, 0, 0},
                                     {1, 1, 1},          {1, 1, -1},      {1e9, 1, 1e-9},   {1e-9, 1e-9, -1e-9}};
  for (const Vector3d& s : all)
    for (int turn = 0; turn < 20; ++turn) {
      const Matrix3d f = random.rotation() * s.asDiagonal() * random.rotation();
      const SignedSvd svd = signed_svd(f);
      CAPTURE(s.transpose(), svd.s.transpose());
      CHECK((svd.u * svd.s.asDiagonal() * svd.v.transpose() - f).norm() <= 1e-14 * f.norm());
      CHECK(svd.u.determinant() == Approx(1));
      CHECK(svd.v.determinant() == Approx(1));
      CHECK(svd.s[0] >= svd.s[1]);
      CHECK(svd.s[1] >= std::abs(svd.s[2]));
      CHECK((svd.s - sorted(s)).norm() <= 1e-14 * s.norm());
    }
}
