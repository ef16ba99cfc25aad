#include "sim/reference/elasticity.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <type_traits>

#include "sim/material/symmetric_eigen.h"
#include "tests/sim/reference/box_model.h"

namespace fascia::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::Random;
using test::soft;

const std::vector<double> poisson_ratios = {-0.9, 0.0, 0.3, 0.45, 0.49, 0.499};

struct RandomTet {
  Corners rest, displacements;
  Matrix3d previous_strain;
};

// An irregular tet of size 0.1 m, displaced by up to a fifth of that (J stays positive) and rotated, with a previous
// strain.
RandomTet random_tet(Random& random) {
  RandomTet tet;
  tet.rest = {Vector3d(0, 0, 0), Vector3d(0.1, 0, 0), Vector3d(0, 0.1, 0), Vector3d(0, 0, 0.1)};
  const Matrix3d turn = random.rotation();
  for (int a = 0; a < 4; ++a) {
    tet.rest[a] += 0.02 * random.vector();
    tet.displacements[a] = turn * (tet.rest[a] + 0.01 * random.vector()) - tet.rest[a];
  }
  const Matrix3d any = Matrix3d::NullaryExpr([&] { return 0.1 * random(); });
  tet.previous_strain = any + any.transpose();
  return tet;
}

Vector12d flat(const Corners& corners) {
  Vector12d all;
  for (int a = 0; a < 4; ++a) all.segment<3>(3 * a) = corners[a];
  return all;
}

Corners corners_of(const Vector12d& all) {
  return {all.segment<3>(0), all.segment<3>(3), all.segment<3>(6), all.segment<3>(9)};
}

// The energy is a polynomial of degree 4 in the displacements, for which the five-point stencil has no truncation
// error: the rest is rounding, 1e-16 / (step / size) relative.
template <class Function>
std::invoke_result_t<Function, double> derivative(const Function& f, double step) {
  return ((8 * (f(step) - f(-step)) - (f(2 * step) - f(-2 * step))) / (12 * step));
}

TEST_CASE("the gradient is the derivative of the energy", "[elasticity]") {
  Random random(1);
  for (const double nu : poisson_ratios)
    for (const double damping_over_h : {0.0, 2.5}) {
      const RandomTet tet = random_tet(random);
      const LinearTet rest(tet.rest);
      Material material = soft(1e5, nu);
      material.model = MaterialModel::st_venant_kirchhoff;
      const Derivatives exact =
          elastic(rest, tet.displacements, material, damping_over_h, tet.previous_strain, false, false);
      Vector12d differences;
      for (int i = 0; i < 12; ++i)
        differences[i] = derivative(
            [&](double step) {
              Vector12d u = flat(tet.displacements);
              u[i] += step;
              return elastic(rest, corners_of(u), material, damping_over_h, tet.previous_strain, false, false).energy;
            },
            1e-2);
      CAPTURE(nu, damping_over_h, exact.gradient.norm());
      CHECK((exact.gradient - differences).norm() < 1e-11 * exact.gradient.norm());
    }
}

TEST_CASE("the Hessian is symmetric and the derivative of the gradient", "[elasticity]") {
  Random random(2);
  for (const double nu : poisson_ratios)
    for (const double damping_over_h : {0.0, 2.5}) {
      const RandomTet tet = random_tet(random);
      const LinearTet rest(tet.rest);
      Material material = soft(1e5, nu);
      material.model = MaterialModel::st_venant_kirchhoff;
      const Derivatives exact =
          elastic(rest, tet.displacements, material, damping_over_h, tet.previous_strain, true, false);
      Matrix12d differences;
      for (int i = 0; i < 12; ++i)
        differences.col(i) = derivative(
            [&](double step) -> Vector12d {
              Vector12d u = flat(tet.displacements);
              u[i] += step;
              return elastic(rest, corners_of(u), material, damping_over_h, tet.previous_strain, false, false).gradient;
            },
            1e-2);
      CAPTURE(nu, damping_over_h, exact.hessian.norm());
      CHECK((exact.hessian - exact.hessian.transpose()).norm() < 1e-15 * exact.hessian.norm());
      CHECK((exact.hessian - differences).norm() < 1e-11 * exact.hessian.norm());
    }
}

// What damping adds is a share of what it adds with St. Venant-Kirchhoff's law, in energy, force and stiffness alike.
TEST_CASE("a drawn-out tet of the squared law is damped by its share", "[elasticity]") {
  Random random(15);
  for (const double stretch : {0.7, 1.0, 1.5, 3.0}) {
    RandomTet tet = random_tet(random);
    tet.previous_strain = 0.5 * (stretch * stretch - 1) * Matrix3d::Identity();
    const LinearTet rest(tet.rest);
    const auto added = [&](MaterialModel model) {
      Material material = soft(1e5, 0.4);
      material.model = model;
      Derivatives d = elastic(rest, tet.displacements, material, 2.5, tet.previous_strain, true, false);
      const Derivatives still = elastic(rest, tet.displacements, material, 0, tet.previous_strain, true, false);
      d.energy -= still.energy;
      d.gradient -= still.gradient;
      d.hessian -= still.hessian;
      return d;
    };
    const Derivatives squared = added(MaterialModel::squared), usual = added(MaterialModel::st_venant_kirchhoff);
    const double share = std::min(1.0, 1 / (stretch * stretch));
    CAPTURE(stretch, share, squared.energy, usual.energy);
    CHECK(squared.energy == Approx(share * usual.energy).epsilon(1e-11));
    CHECK((squared.gradient - share * usual.gradient).norm() < 1e-11 * usual.gradient.norm());
    CHECK((squared.hessian - share * usual.hessian).norm() < 1e-11 * usual.hessian.norm());
  }
}

TEST_CASE("the energy is half of strain times stress in the six-vector form with tensor shears", "[elasticity]") {
  Random random(3);
  for (const double nu : poisson_ratios) {
    const RandomTet tet = random_tet(random);
    const LinearTet rest(tet.rest);
    const Material material = soft(2e4, nu);
    const Vector6d c = green_strain(rest.deformation_gradient(tet.displacements));
    Eigen::Matrix<double, 6, 6> d = Eigen::Matrix<double, 6, 6>::Zero();
    d.topLeftCorner<3, 3>().setConstant(material.lame_lambda());
    d.diagonal().head<3>().array() += 2 * material.lame_mu();
    d.diagonal().tail<3>().setConstant(4 * material.lame_mu());
    const double expected = 0.5 * rest.volume * c.dot(d * c);
    const double energy = elastic(rest, tet.displacements, material, 0, Matrix3d::Zero(), false, false).energy;
    CAPTURE(nu);
    CHECK(energy == Approx(expected).epsilon(1e-12));
  }
}

TEST_CASE("a stretched tet has the energy and stress of the closed form", "[elasticity]") {
  const LinearTet rest({Vector3d(0, 0, 0), Vector3d(0.2, 0, 0), Vector3d(0, 0.3, 0), Vector3d(0, 0, 0.1)});
  CHECK(rest.volume == Approx(0.2 * 0.3 * 0.1 / 6).epsilon(1e-15));
  const Material material = soft(1e5, 0.25);  // lambda = mu = 4e4 Pa
  const double stretch = 1.5, strain = 0.5 * (stretch * stretch - 1);
  const Corners u = {Vector3d::Zero(), Vector3d(0.2 * (stretch - 1), 0, 0), Vector3d::Zero(), Vector3d::Zero()};
  const Derivatives d = elastic(rest, u, material, 0, Matrix3d::Zero(), false, false);
  CHECK(d.energy == Approx(rest.volume * (0.5 * 4e4 + 4e4) * strain * strain).epsilon(1e-14));
  // Force on the corner at x = 0.2: V * first Piola stress / edge.
  CHECK(d.gradient[3] == Approx(rest.volume * stretch * 12e4 * strain / 0.2).epsilon(1e-14));
  // Cauchy stress: axial P = stretch S, across (lambda strain) / stretch; von Mises is their difference.
  const double axial = stretch * 12e4 * strain, across = 4e4 * strain / stretch;
  CHECK(von_mises(rest.deformation_gradient(u), material) == Approx(axial - across).epsilon(1e-13));
  CHECK(von_mises(0.8 * Matrix3d::Identity(), material) < 1e-10 * 1e5);
  CHECK(std::isfinite(von_mises(Vector3d(1, 1, 0).asDiagonal(), material)));
}

TEST_CASE("rigid motion has no energy and no force, and rest has exactly none", "[elasticity]") {
  Random random(4);
  for (const double nu : poisson_ratios) {
    const RandomTet tet = random_tet(random);
    const LinearTet rest(tet.rest);
    const Material material = soft(1e6, nu);
    const Matrix3d turn = random.rotation();
    const Vector3d shift = random.vector();
    Corners u, still = {shift, shift, shift, shift};
    for (int a = 0; a < 4; ++a) u[a] = turn * tet.rest[a] + shift - tet.rest[a];
    const Derivatives moved = elastic(rest, u, material, 0, Matrix3d::Zero(), false, false);
    // F is accurate to a few 1e-16, and so is the strain; the stiffest modulus times an area converts that to a force.
    const double modulus = std::abs(material.lame_lambda()) + 2 * material.lame_mu();
    CAPTURE(nu, modulus, moved.gradient.norm());
    CHECK(moved.gradient.norm() < 1e-13 * modulus * 0.01);
    CHECK(moved.energy < 1e-26 * modulus * rest.volume);
    const Derivatives shifted = elastic(rest, still, material, 0, Matrix3d::Zero(), false, false);
    CHECK(shifted.energy == 0);
    CHECK(shifted.gradient.norm() == 0);
  }
}

TEST_CASE("rotating the deformed tet rotates its force and its stiffness", "[elasticity]") {
  Random random(5);
  for (const double nu : poisson_ratios) {
    const RandomTet tet = random_tet(random);
    const LinearTet rest(tet.rest);
    const Material material = soft(1e5, nu);
    const Matrix3d turn = random.rotation();
    Matrix12d turn_all = Matrix12d::Zero();
    Corners turned;
    for (int a = 0; a < 4; ++a) {
      turned[a] = turn * (tet.rest[a] + tet.displacements[a]) - tet.rest[a];
      turn_all.block<3, 3>(3 * a, 3 * a) = turn;
    }
    const Derivatives before = elastic(rest, tet.displacements, material, 1.5, tet.previous_strain, true, false);
    const Derivatives after = elastic(rest, turned, material, 1.5, tet.previous_strain, true, false);
    CAPTURE(nu);
    CHECK(after.energy == Approx(before.energy).epsilon(1e-12));
    CHECK((after.gradient - turn_all * before.gradient).norm() < 1e-12 * before.gradient.norm());
    CHECK((after.hessian - turn_all * before.hessian * turn_all.transpose()).norm() < 1e-12 * before.hessian.norm());
  }
}

TEST_CASE("the projected Hessian has no negative eigenvalue and keeps the positive ones", "[elasticity]") {
  const LinearTet rest({Vector3d(0, 0, 0), Vector3d(0.1, 0, 0), Vector3d(0, 0.1, 0), Vector3d(0, 0, 0.1)});
  for (const double nu : poisson_ratios) {
    Corners squeezed = {Vector3d::Zero(), Vector3d(-0.05, 0, 0), Vector3d::Zero(), Vector3d(0.01, 0, 0)};
    const Derivatives plain = elastic(rest, squeezed, soft(1e5, nu), 0, Matrix3d::Zero(), true, false);
    const Derivatives projected = elastic(rest, squeezed, soft(1e5, nu), 0, Matrix3d::Zero(), true, true);
    const Vector12d before = symmetric_eigen(plain.hessian).values;
    const Vector12d after = symmetric_eigen(projected.hessian).values;
    const double rounding = 1e-14 * before[11];
    CAPTURE(nu, before.transpose(), after.transpose());
    CHECK(before[0] < -1e3 * rounding);  // otherwise nothing was tested
    CHECK(after[0] > -rounding);
    CHECK((after - before.cwiseMax(0.0)).norm() < 10 * rounding);
    CHECK(projected.gradient == plain.gradient);
  }
}

TEST_CASE("small strains keep their accuracy", "[elasticity]") {
  const LinearTet rest({Vector3d(0, 0, 0), Vector3d(0.1, 0, 0), Vector3d(0, 0.1, 0), Vector3d(0, 0, 0.1)});
  const Corners u = {Vector3d(0, 0, 0), Vector3d(1e-13, 0, 0), Vector3d(0, 0, 0), Vector3d(0, 3e-13, 0)};
  const Matrix3d strain = green_strain_matrix(rest, u);
  CHECK(strain(0, 0) == Approx(1e-12).epsilon(1e-11));  // the quadratic term is 1e-12 of the linear one
  CHECK(strain(1, 2) == Approx(1.5e-12).epsilon(1e-11));
  CHECK(strain(2, 1) == strain(1, 2));
}

}  // namespace
}  // namespace fascia::reference
