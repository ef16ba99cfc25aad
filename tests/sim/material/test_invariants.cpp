// Cofactors, their products and the extension of log J, against differences and definitions.
#include "sim/material/invariants.h"

#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>
#include <initializer_list>
#include <random>

using namespace fascia;
using Eigen::Matrix3d;

namespace {

Matrix3d random_matrix(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Matrix3d::NullaryExpr([&] { return uniform(random); });
}

}  // namespace

TEST_CASE("the cofactor is the derivative of the determinant, of singular matrices, too") {
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i) {
    Matrix3d f = random_matrix(random);
    if (i % 5 == 1) f.col(2) = f.col(0) - 2 * f.col(1);
    if (i % 5 == 2) f.setZero();
    const Matrix3d direction = random_matrix(random);
    constexpr double kStep = 1e-5;
    const double difference =
        ((f + kStep * direction).determinant() - (f - kStep * direction).determinant()) / (2 * kStep);
    const double derivative = flat(cofactor(f)).dot(flat(direction));
    CAPTURE(i, difference, derivative);
    CHECK(std::abs(difference - derivative) < 1e-9);
    if (i % 5 == 0)  // cof F = J F^-T
      CHECK((cofactor(f) - f.determinant() * f.inverse().transpose()).norm() < 1e-12);
  }
}

TEST_CASE("the tensor cross product is that of Bonet, Gil and Ortigosa") {
  std::mt19937 random(2);
  for (int i = 0; i < 50; ++i) {
    const Matrix3d a = random_matrix(random), b = random_matrix(random), c = random_matrix(random);
    CAPTURE(i);
    CHECK((tensor_cross(a, a) - 2 * cofactor(a)).norm() < 1e-14);
    CHECK((tensor_cross(a, b) - tensor_cross(b, a)).norm() < 1e-14);
    CHECK((tensor_cross(a + 2 * c, b) - tensor_cross(a, b) - 2 * tensor_cross(c, b)).norm() < 1e-13);
    // The cofactor is quadratic, so that its central difference is its derivative.
    CHECK((tensor_cross(a, b) - (cofactor(a + b) - cofactor(a - b)) / 2).norm() < 1e-13);
    // Equation 7 with the Levi-Civita symbol.
    Matrix3d sum = Matrix3d::Zero();
    constexpr int kEven[3][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}};
    for (const auto& [p, i1, i2] : kEven)
      for (const auto& [q, j1, j2] : kEven)
        sum(p, q) = a(i1, j1) * b(i2, j2) - a(i1, j2) * b(i2, j1) - a(i2, j1) * b(i1, j2) + a(i2, j2) * b(i1, j1);
    CHECK((tensor_cross(a, b) - sum).norm() < 1e-14);
  }
}

TEST_CASE("components stand column by column") {
  Matrix3d m;
  m << 1, 4, 7, 2, 5, 8, 3, 6, 9;
  for (int k = 0; k < 9; ++k) CHECK(flat(m)[k] == k + 1);
}

TEST_CASE("differences from rest are those of the measures, and keep the digits of small strains") {
  Matrix3d f;
  f << 1.1, 0.35, -0.2, 0.1, 0.7, 0.25, -0.3, 0.15, 0.95;
  const FromRest large = from_rest(f);
  CHECK((large.cofactor + Matrix3d::Identity() - cofactor(f)).norm() < 1e-15);
  CHECK(large.stretch == Approx(f.squaredNorm() - 3));
  CHECK(large.volume == Approx(f.determinant() - 1));
  CHECK(large.higher == Approx(f.determinant() - 1 - (f - Matrix3d::Identity()).trace()));
  // A shear by a power of two: F has all digits, and the exact values are known.
  const double shear = std::ldexp(1, -30);
  f = Matrix3d::Identity();
  f(0, 1) = shear;
  const FromRest small = from_rest(f);
  CHECK(small.stretch == shear * shear);
  CHECK(small.volume == 0);
  f(1, 0) = shear;
  CHECK(from_rest(f).higher == -shear * shear);
}

TEST_CASE("the extended logarithm is log J above the least ratio, and its parabola below it") {
  for (const double j : {0.2, 0.5, 1.0, 3.0}) {
    const OfVolume at = above_extended_log(j - 1);
    CAPTURE(j);
    CHECK(at.value == Approx(j - 1 - std::log(j)).margin(1e-15));
    CHECK(at.first == Approx(1 - 1 / j));
    CHECK(at.second == Approx(1 / (j * j)));
  }
  CHECK(above_extended_log(1e-8).value == Approx(0.5e-16).epsilon(1e-7));
  // The parabola that has the logarithm's value, slope and curvature at the least ratio.
  const double r = kLeastVolumeRatio;
  for (const double j : {0.19, 0.0, -1.0, -10.0}) {
    const OfVolume at = above_extended_log(j - 1);
    CAPTURE(j, at.value);
    CHECK(at.value == Approx(j - 1 - (std::log(r) + (j - r) / r - (j - r) * (j - r) / (2 * r * r))));
    CHECK(at.first == Approx(1 - (1 / r - (j - r) / (r * r))));
    CHECK(at.second == Approx(1 / (r * r)));
  }
}

TEST_CASE("first and second derivatives are those of the values, and all three go on where the formula changes") {
  const auto functions = {+[](double j) { return above_extended_log(j - 1); },
                          +[](double j) { return volume_term(j, 2.5); },
                          +[](double j) { return volume_term(j, -1.5); }};
  int number = 0;
  for (const auto& of : functions) {
    ++number;
    constexpr double kStep = 1e-5;
    for (const double j : {-2.0, -0.1, 0.1, 0.3, 0.9, 1.2, 4.0}) {
      const OfVolume at = of(j), before = of(j - kStep), behind = of(j + kStep);
      CAPTURE(number, j, at.value, at.first, at.second);
      CHECK(at.first == Approx((behind.value - before.value) / (2 * kStep)).epsilon(1e-7).margin(1e-9));
      CHECK(at.second == Approx((behind.first - before.first) / (2 * kStep)).epsilon(1e-7).margin(1e-9));
    }
    for (const double joint : {kLeastVolumeRatio, 1.0}) {
      const OfVolume below = of(joint * (1 - 1e-12)), above = of(joint * (1 + 1e-12));
      CAPTURE(number, joint);
      CHECK(below.value == Approx(above.value).margin(1e-10));
      CHECK(below.first == Approx(above.first).margin(1e-10));
      CHECK(below.second == Approx(above.second).margin(1e-10));
    }
  }
}

TEST_CASE("a negative multiple of the volume term has a lower bound where the body grows") {
  CHECK(volume_term(3, 2).value == 4);  // 2 * 2^2 / 2
  CHECK(volume_term(1, -2).value == 0);
  CHECK(volume_term(1e6, -2).value == Approx(-std::pow(std::log(1e6), 2)));
  CHECK(volume_term(0.5, -2).value == Approx(-0.25));
}
