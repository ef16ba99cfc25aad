#include "sim/material/symmetric_eigen.h"

#include <catch2/catch.hpp>
#include <random>

using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace fascia;

namespace {

MatrixXd random_square(int size, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  return MatrixXd::NullaryExpr(size, size, [&] { return uniform(random); });
}

bool ascends(const VectorXd& values) { return std::is_sorted(values.begin(), values.end()); }

}  // namespace

TEST_CASE("eigenvalues of a symmetric matrix ascend, and its eigenvectors are orthonormal") {
  std::mt19937 random(1);
  for (const int size : {1, 2, 12, 30}) {
    const MatrixXd half = random_square(size, random), a = half + half.transpose();
    const SymmetricEigen eigen = symmetric_eigen(a);
    CAPTURE(size);
    CHECK(ascends(eigen.values));
    CHECK((a * eigen.vectors - eigen.vectors * eigen.values.asDiagonal()).norm() < 1e-13 * size);
    CHECK((eigen.vectors.transpose() * eigen.vectors - MatrixXd::Identity(size, size)).norm() < 1e-13 * size);
  }
}

TEST_CASE("generalized eigenvectors are orthonormal in the second matrix") {
  std::mt19937 random(2);
  for (const int size : {1, 12}) {
    const MatrixXd half = random_square(size, random), root = random_square(size, random);
    const MatrixXd a = half + half.transpose(), b = root * root.transpose() + MatrixXd::Identity(size, size);
    const SymmetricEigen eigen = symmetric_eigen(a, b);
    CAPTURE(size);
    CHECK(ascends(eigen.values));
    CHECK((a * eigen.vectors - b * eigen.vectors * eigen.values.asDiagonal()).norm() < 1e-12 * size);
    CHECK((eigen.vectors.transpose() * b * eigen.vectors - MatrixXd::Identity(size, size)).norm() < 1e-12 * size);
  }
}
