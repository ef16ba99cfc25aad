// The energy of one quadratic tet: derivatives in easy and hard states of every law, invariance, and agreement with the
// linear tet on affine displacements.
#include "sim/reference/quadratic_elasticity.h"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "sim/material/law.h"
#include "sim/material/symmetric_eigen.h"
#include "tests/sim/reference/box_model.h"

namespace fascia::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::Random;
using Result = ElementDerivatives<10>;
using Vector30d = Eigen::Matrix<double, 30, 1>;

const Corners kStraight{Vector3d(0, 0, 0), Vector3d(0.1, 0, 0), Vector3d(0.01, 0.12, 0), Vector3d(0, 0.02, 0.09)};
const QuadraticTet kTet{LinearTet(kStraight)};

Material tissue_of(MaterialModel model, double nu) { return {1e5, nu, 1000, 0, model, 0.3}; }

Vector30d rest_nodes() {
  Vector30d x;
  for (int a = 0; a < 4; ++a) x.segment<3>(3 * a) = kStraight[static_cast<std::size_t>(a)];
  for (int m = 0; m < 6; ++m) {
    const auto [a, b] = kMidEdgeCorners[static_cast<std::size_t>(m)];
    x.segment<3>(12 + 3 * m) = 0.5 * (kStraight[a] + kStraight[b]);
  }
  return x;
}

QuadraticTet::Nodes nodes(const Vector30d& u) {
  QuadraticTet::Nodes all;
  for (int n = 0; n < 10; ++n) all[static_cast<std::size_t>(n)] = u.segment<3>(3 * n);
  return all;
}

Vector30d affine(const Matrix3d& f, const Vector3d& by = Vector3d::Zero()) {
  Vector30d u = rest_nodes();
  for (int n = 0; n < 10; ++n) u.segment<3>(3 * n) = f * u.segment<3>(3 * n) + by - u.segment<3>(3 * n);
  return u;
}

/// Affine displacements and a bump of every node by up to `bump` [m], the edges bent.
Vector30d bent(Random& random, const Vector3d& stretches, double bump) {
  return affine(random.rotation() * stretches.asDiagonal() * random.rotation(), random.vector()) +
         bump * Vector30d(random.vector(30));
}

// Mean stretches of easy and of hard states: compressed below kLeastStretch, flat, inside out.
const std::vector<Vector3d> kStates = {{1, 1, 1},        {1.2, 0.9, 0.8}, {1.2, 0.9, 0.3}, {1.2, 0.9, 0.02},
                                       {1.1, 1.0, -0.5}, {0.3, 0.2, 0.1}, {2.5, 1.0, -0.9}};

PointStrains some_strains(Random& random) {
  PointStrains strains;
  for (Matrix3d& at : strains) {
    const Matrix3d any = Matrix3d::NullaryExpr([&] { return 0.1 * random(); });
    at = any + any.transpose();
  }
  return strains;
}

}  // namespace

TEST_CASE("forces of a quadratic tet are derivatives of its energy, its Hessian of its forces", "[quadratic]") {
  const MaterialModel model = GENERATE(from_range(material_models()));
  const double nu = GENERATE(-0.5, 0.1, 0.3, 0.49), damping_over_h = GENERATE(0.0, 1.5);
  const Material material = tissue_of(model, nu);
  Random random(21);
  for (const Vector3d& s : kStates) {
    const Vector30d u = bent(random, s, 0.004);
    const PointStrains previous = some_strains(random);
    const auto at = [&](const Vector30d& moved, bool with_hessian) {
      return elastic(kTet, nodes(moved), material, damping_over_h, previous, with_hessian, false);
    };
    const Result exact = at(u, true);
    constexpr double kStep = 1e-6;
    Vector30d slope;
    Eigen::MatrixXd bend(30, 30);
    for (int i = 0; i < 30; ++i) {
      const Vector30d step = kStep * Vector30d::Unit(i);
      const Result after = at(u + step, false), before = at(u - step, false);
      slope[i] = (after.energy - before.energy) / (2 * kStep);
      bend.col(i) = (after.gradient - before.gradient) / (2 * kStep);
    }
    CAPTURE(name_of(model), nu, damping_over_h, s.transpose(), exact.gradient.norm(), exact.hessian.norm(),
            (exact.gradient - slope).norm(), (exact.hessian - bend).norm());
    CHECK((exact.gradient - slope).norm() < 1e-7 * (exact.gradient.norm() + exact.hessian.norm() * 0.1));
    CHECK((exact.hessian - bend).norm() < 1e-6 * exact.hessian.norm());
    CHECK((exact.hessian - exact.hessian.transpose()).norm() < 1e-12 * exact.hessian.norm());
    const Result without = at(u, false);
    CHECK(without.energy == exact.energy);
    CHECK(without.gradient == exact.gradient);
  }
}

TEST_CASE("on affine displacements a quadratic tet has the energy of the linear one", "[quadratic]") {
  const MaterialModel model = GENERATE(from_range(material_models()));
  const double nu = GENERATE(-0.5, 0.0, 0.3, 0.499);
  Random random(22);
  for (const Vector3d& s : kStates) {
    const Material material = tissue_of(model, nu);
    const Matrix3d f = random.rotation() * s.asDiagonal() * random.rotation();
    const Vector30d u = affine(f, {1, -2, 3});
    const Matrix3d before = 0.1 * Matrix3d::Identity();
    const PointStrains previous{before, before, before, before};
    const Result ten = elastic(kTet, nodes(u), material, 1.5, previous, false, false);
    const Corners corners{u.segment<3>(0), u.segment<3>(3), u.segment<3>(6), u.segment<3>(9)};
    const Derivatives four = elastic(LinearTet(kStraight), corners, material, 1.5, before, false, false);
    // Forces: those of the linear tet, with half of a mid-edge node's on either end.
    Vector12d lumped = ten.gradient.head<12>();
    for (int m = 0; m < 6; ++m)
      for (const std::size_t end : kMidEdgeCorners[static_cast<std::size_t>(m)])
        lumped.segment<3>(3 * static_cast<int>(end)) += 0.5 * ten.gradient.segment<3>(12 + 3 * m);
    CAPTURE(name_of(model), nu, s.transpose(), four.energy, ten.energy);
    CHECK(ten.energy == Approx(four.energy).epsilon(1e-10));
    CHECK((lumped - four.gradient).norm() < 1e-10 * four.gradient.norm());
    const Matrix3d p = first_piola_stress(kTet, nodes(u), material), linear = first_piola_stress(f, material);
    CHECK((p - linear).norm() < 1e-9 * (linear.norm() + material.young_modulus));
  }
}

TEST_CASE("rigid motion of a quadratic tet costs nothing, and turns its forces with it", "[quadratic]") {
  const MaterialModel model = GENERATE(from_range(material_models()));
  const Material material = tissue_of(model, 0.45);
  Random random(23);
  const Result rigid =
      elastic(kTet, nodes(affine(random.rotation(), {3, 1, -2})), material, 0, no_strains(), true, false);
  CAPTURE(name_of(model), rigid.energy, rigid.gradient.norm());
  CHECK(std::abs(rigid.energy) < 1e-12 * kTet.volume * material.young_modulus);
  CHECK(rigid.gradient.norm() < 1e-12 * rigid.hessian.norm());
  for (const Vector3d& s : kStates) {
    const Vector30d u = bent(random, s, 0.004), x = u + rest_nodes();
    const Matrix3d turn = random.rotation();
    Vector30d turned;
    for (int n = 0; n < 10; ++n) turned.segment<3>(3 * n) = turn * x.segment<3>(3 * n) - rest_nodes().segment<3>(3 * n);
    const PointStrains previous = some_strains(random);
    const Result before = elastic(kTet, nodes(u), material, 1.5, previous, false, false);
    const Result after = elastic(kTet, nodes(turned), material, 1.5, previous, false, false);
    CHECK(after.energy == Approx(before.energy).epsilon(1e-10));
    Vector3d force(0, 0, 0), torque(0, 0, 0);
    for (int n = 0; n < 10; ++n) {
      const Vector3d own = before.gradient.segment<3>(3 * n);
      CHECK((after.gradient.segment<3>(3 * n) - turn * own).norm() < 1e-9 * before.gradient.norm());
      force += own;
      torque += x.segment<3>(3 * n).cross(own);
    }
    CHECK(force.norm() < 1e-12 * before.gradient.norm());
    CHECK(torque.norm() < 1e-12 * before.gradient.norm() * x.norm());
  }
}

TEST_CASE("St. Venant-Kirchhoff with averaged pressure has the energy of its formula", "[quadratic]") {
  const Material material = tissue_of(MaterialModel::signed_st_venant_kirchhoff, 0.4);
  Random random(24);
  const Vector30d u = bent(random, {1.2, 1.0, 0.9}, 0.003);
  const PointStrains strains = green_strains(kTet, nodes(u));
  double squared = 0, trace = 0;
  for (const Matrix3d& strain : strains) {
    squared += 0.25 * strain.squaredNorm();
    trace += 0.25 * strain.trace();
  }
  const double exact = kTet.volume * (material.lame_mu() * squared + 0.5 * material.lame_lambda() * trace * trace);
  const Result found = elastic(kTet, nodes(u), material, 0, no_strains(), false, false);
  CHECK(found.energy == Approx(exact).epsilon(1e-12));
}

TEST_CASE("the clamped Hessian of a quadratic tet has no negative eigenvalue", "[quadratic]") {
  const Material material = tissue_of(MaterialModel::squared, 0.45);
  const Vector30d u = affine(Vector3d(0.7, 0.6, 0.5).asDiagonal());
  const auto least = [&](bool project) {
    const Result d = elastic(kTet, nodes(u), material, 0, no_strains(), true, project);
    return symmetric_eigen(d.hessian).values[0] / d.hessian.norm();
  };
  CHECK(least(false) < -1e-3);
  CHECK(least(true) > -1e-12);
}

TEST_CASE("volume ratios of a quadratic tet are those of its points, and of its corners where asked for",
          "[quadratic]") {
  const VolumeRatios same = volume_ratios(kTet, nodes(affine(2 * Matrix3d::Identity())), true);
  CHECK(same.min == Approx(8).epsilon(1e-12));
  CHECK(same.max == Approx(8).epsilon(1e-12));
  Vector30d u = Vector30d::Zero();  // the middle of edge 01 moves by 0.3 of the edge, against corner 0
  u.segment<3>(12) = 0.3 * (kStraight[0] - kStraight[1]);
  const VolumeRatios points = volume_ratios(kTet, nodes(u), false), all = volume_ratios(kTet, nodes(u), true);
  CHECK(all.min == Approx(1 - 4 * 0.3).epsilon(1e-12));  // dF at corner 0: 4 u g_1
  CHECK(all.max == Approx(1 + 4 * 0.3).epsilon(1e-12));
  CHECK(points.min > 0);
  CHECK(points.max < all.max);
}

}  // namespace fascia::reference
