// The quadratic tet on quadratic fields, which it represents exactly.
#include "sim/elements/quadratic_tet.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "sim/mesh/tet_mesh.h"

using namespace fascia;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;

namespace {

const Corners kRest = {Vector3d(0.1, 0.2, -0.1), Vector3d(1.3, 0.1, 0.2), Vector3d(0.3, 0.9, 0.1),
                       Vector3d(0.2, 0.4, 1.1)};

/// u = a + B x + (x . C_i x) e_i.
struct QuadraticField {
  Vector3d a{3, -2, 5};
  Matrix3d b = (Matrix3d() << 0.1, 0.3, -0.2, 0.5, -0.4, 0.2, 0.05, -0.3, 0.2).finished();
  std::array<Matrix3d, 3> c = {(Matrix3d() << 0.3, 0.1, 0.2, 0.1, -0.2, 0.4, 0.2, 0.4, 0.1).finished(),
                               (Matrix3d() << -0.1, 0.2, 0.3, 0.2, 0.5, -0.3, 0.3, -0.3, 0.2).finished(),
                               (Matrix3d() << 0.2, -0.4, 0.1, -0.4, 0.1, 0.2, 0.1, 0.2, -0.6).finished()};
  Vector3d value(const Vector3d& x) const {
    return a + b * x + Vector3d(x.dot(c[0] * x), x.dot(c[1] * x), x.dot(c[2] * x));
  }
  Matrix3d gradient(const Vector3d& x) const {
    Matrix3d h = b;
    for (int i = 0; i < 3; ++i) h.row(i) += 2 * (c[static_cast<std::size_t>(i)] * x).transpose();
    return h;
  }
};

std::array<Vector3d, 10> nodes_at_rest() {
  std::array<Vector3d, 10> x;
  std::copy(kRest.begin(), kRest.end(), x.begin());
  for (std::size_t m = 0; m < 6; ++m) x[4 + m] = 0.5 * (kRest[kMidEdgeCorners[m][0]] + kRest[kMidEdgeCorners[m][1]]);
  return x;
}

Vector3d place(const Vector4d& barycentric) {
  Vector3d x = Vector3d::Zero();
  for (std::size_t a = 0; a < 4; ++a) x += barycentric[static_cast<int>(a)] * kRest[a];
  return x;
}

Vector4d point(int q) {
  Vector4d l = Vector4d::Constant(QuadraticTet::kFar);
  l[q] = QuadraticTet::kNear;
  return l;
}

}  // namespace

TEST_CASE("a quadratic tet has the gradients of a quadratic field at its points, its corners and its centroid") {
  const QuadraticTet tet{LinearTet(kRest)};
  const QuadraticField field;
  QuadraticTet::Nodes u = nodes_at_rest();
  for (Vector3d& at : u) at = field.value(at);
  const auto by_points = tet.at_points(u), by_corners = tet.at_corners(u);
  for (int q = 0; q < 4; ++q) {
    const auto n = static_cast<std::size_t>(q);
    CAPTURE(q, by_points[n], by_corners[n]);
    CHECK((by_points[n] - field.gradient(place(point(q)))).norm() < 1e-13);
    CHECK((by_corners[n] - field.gradient(kRest[n])).norm() < 1e-13);
  }
  CHECK((tet.at_centroid(u) - field.gradient(place(Vector4d::Constant(0.25)))).norm() < 1e-13);
}

TEST_CASE("shape gradients of a quadratic tet reproduce quadratic fields anywhere and sum to zero") {
  const QuadraticTet tet{LinearTet(kRest)};
  const QuadraticField field;
  const auto x = nodes_at_rest();
  for (const Vector4d& l : {Vector4d(0.7, 0.1, 0.15, 0.05), Vector4d(0, 0, 0.4, 0.6), Vector4d(-0.2, 0.6, 0.3, 0.3)}) {
    const QuadraticTet::ShapeGradients shape = tet.shape_gradients(l);
    Matrix3d h = Matrix3d::Zero();
    for (int n = 0; n < 10; ++n) h += field.value(x[static_cast<std::size_t>(n)]) * shape.col(n).transpose();
    CAPTURE(l.transpose(), h);
    CHECK((h - field.gradient(place(l))).norm() < 1e-12);  // the field's values of 5 cost a digit
    CHECK(shape.rowwise().sum().norm() < 1e-14);
  }
  for (int q = 0; q < 4; ++q) CHECK(tet.shape_gradients_at_point(q) == tet.shape_gradients(point(q)));
}

TEST_CASE("four points integrate quadratic functions of a quadratic tet exactly") {
  // The mean of L_a L_b over a tet is 1/20, of L_a^2 1/10.
  double mixed = 0, square = 0, linear = 0;
  for (int q = 0; q < 4; ++q) {
    linear += 0.25 * point(q)[0];
    square += 0.25 * point(q)[0] * point(q)[0];
    mixed += 0.25 * point(q)[0] * point(q)[1];
  }
  CHECK(linear == Approx(0.25).epsilon(1e-14));
  CHECK(square == Approx(0.1).epsilon(1e-14));
  CHECK(mixed == Approx(0.05).epsilon(1e-14));
}

TEST_CASE("what moves at the centroid leaves a quadratic tet its mass, its center and its second moments") {
  const Corners x{Vector3d(0.1, -0.2, 0.3), Vector3d(1.3, 0.1, 0.2), Vector3d(0.2, 0.9, -0.1), Vector3d(0.4, 0.3, 1.7)};
  double mass = QuadraticTet::kCentroidMass;
  Vector3d center = Vector3d::Zero(), sum = Vector3d::Zero();
  Matrix3d moments = Matrix3d::Zero(), exact = Matrix3d::Zero();
  const auto add = [&](double m, const Vector3d& at) {
    center += m * at;
    moments += m * at * at.transpose();
  };
  Vector3d centroid = Vector3d::Zero();
  for (const Vector3d& corner : x) {
    mass += QuadraticTet::kOwnCornerMass;
    add(QuadraticTet::kOwnCornerMass, corner);
    centroid += QuadraticTet::at_centroid(0) * corner;
    sum += corner;
    exact += corner * corner.transpose() / 20;
  }
  for (const auto& [a, b] : kMidEdgeCorners) {
    const Vector3d middle = 0.5 * (x[a] + x[b]);
    mass += QuadraticTet::kOwnMidEdgeMass;
    add(QuadraticTet::kOwnMidEdgeMass, middle);
    centroid += QuadraticTet::at_centroid(4) * middle;
  }
  add(QuadraticTet::kCentroidMass, centroid);
  exact += sum * sum.transpose() / 20;  // the mean of x x^T over a tet: (sum x_a x_a^T + sum x_a sum x_a^T) / 20
  CAPTURE(mass, center.transpose(), moments, exact);
  CHECK(mass == Approx(1).epsilon(1e-14));
  CHECK((center - sum / 4).norm() < 1e-14);
  CHECK((moments - exact).norm() < 1e-14);
}

TEST_CASE("row sums of the mass matrix of a quadratic tet are the integrals of its shape functions") {
  // The mean of L1^a L2^b is a! b! 3! / (a + b + 3)!.
  const double corner = 2 * (2 * 6 / 120.0) - 6 / 24.0, middle = 4 * 6 / 120.0;  // 2 L^2 - L, 4 L1 L2
  for (std::size_t n = 0; n < 10; ++n) {
    const double own = n < 4 ? QuadraticTet::kOwnCornerMass : QuadraticTet::kOwnMidEdgeMass;
    CAPTURE(n);
    CHECK(own + QuadraticTet::kCentroidMass * QuadraticTet::at_centroid(n) ==
          Approx(n < 4 ? corner : middle).epsilon(1e-14));
    CHECK((n < 4 ? QuadraticTet::kCornerLoad : QuadraticTet::kMidEdgeLoad) ==
          Approx(n < 4 ? corner : middle).epsilon(1e-14));
    CHECK(QuadraticTet::at_centroid(n) == Approx(QuadraticTet::shape_functions({0.25, 0.25, 0.25, 0.25})[n]));
  }
}

TEST_CASE("lumped masses of a quadratic tet are in the ratio of the diagonal of its mass matrix") {
  CHECK(4 * QuadraticTet::kCornerMass + 6 * QuadraticTet::kMidEdgeMass == Approx(1).epsilon(1e-15));
  // By the formula of Eisenberg and Malvern 1973: the mean of L1^a L2^b is a! b! 3! / (a + b + 3)!.
  const double corner = 4 * (24 * 6 / 5040.0) - 4 * (6 * 6 / 720.0) + 2 * 6 / 120.0;  // (2 L^2 - L)^2
  const double middle = 16 * (2 * 2 * 6 / 5040.0);                                    // (4 L1 L2)^2
  CAPTURE(corner, middle);
  CHECK(QuadraticTet::kMidEdgeMass / QuadraticTet::kCornerMass == Approx(middle / corner).epsilon(1e-13));
}
