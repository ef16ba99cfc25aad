// Materials that survive inversion: derivatives on mirrored, flat and flattened tets, and agreement with St.
// Venant-Kirchhoff.
#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "sim/reference/elasticity.h"
#include "tests/sim/reference/box_model.h"

namespace fascia::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::Random;

const Corners kRest{Vector3d(0, 0, 0), Vector3d(0.1, 0, 0), Vector3d(0.01, 0.12, 0), Vector3d(0, 0.02, 0.09)};

Material of(MaterialModel model, double nu) { return {1e5, nu, 1000, 0, model}; }

Corners displaced(const Matrix3d& f) {
  Corners u;
  for (int a = 0; a < 4; ++a) u[a] = f * kRest[a] - kRest[a];
  return u;
}

Matrix3d stretched(Random& random, const Vector3d& s) { return random.rotation() * s.asDiagonal() * random.rotation(); }

Vector12d moved(const Corners& corners, int component, double step) {
  Vector12d all;
  for (int a = 0; a < 4; ++a) all.segment<3>(3 * a) = corners[a];
  all[component] += step;
  return all;
}

Derivatives at(const Vector12d& u, const Material& material, bool with_hessian) {
  return elastic(LinearTet(kRest), {u.segment<3>(0), u.segment<3>(3), u.segment<3>(6), u.segment<3>(9)}, material, 0,
                 Matrix3d::Zero(), with_hessian, false);
}

// Principal stretches of the hard cases; none closer to a jump of a second derivative than the step of the differences.
const std::vector<Vector3d> kHard = {{1.1, 0.9, 0.8},  {1.2, 0.9, 0.3},    {1.2, 0.9, 0.0},     {1.1, 1.0, -0.5},
                                     {1.3, 0.4, -0.2}, {0.5, 0.45, -0.35}, {2.5, 1.0, -0.9},    {0.3, 0.2, 0.1},
                                     {1.0, 1.0, 0.4},  {1.0, 0.5, 0.5},    {0.31, 0.3, 0.2999}, {5.0, 3.0, -2.0}};

}  // namespace

TEST_CASE("forces of surviving materials are derivatives of their energy, Hessians of their forces", "[elasticity]") {
  const auto model = GENERATE(MaterialModel::signed_st_venant_kirchhoff, MaterialModel::stable_neo_hookean,
                              MaterialModel::neo_hookean, MaterialModel::mooney_rivlin, MaterialModel::squared);
  const double nu = GENERATE(-0.5, 0.0, 0.3, 0.49);
  const Material material = of(model, nu);
  Random random(12);
  for (const Vector3d& s : kHard) {
    const Corners u = displaced(stretched(random, s));
    const Derivatives exact = at(moved(u, 0, 0), material, true);
    constexpr double kStep = 1e-6;
    Vector12d slope;
    Matrix12d bend;
    for (int i = 0; i < 12; ++i) {
      const Derivatives after = at(moved(u, i, kStep), material, false),
                        before = at(moved(u, i, -kStep), material, false);
      slope[i] = (after.energy - before.energy) / (2 * kStep);
      bend.col(i) = (after.gradient - before.gradient) / (2 * kStep);
    }
    CAPTURE(name_of(model), nu, s.transpose(), exact.gradient.norm(), exact.hessian.norm());
    CHECK((exact.gradient - slope).norm() < 1e-7 * (exact.gradient.norm() + exact.hessian.norm() * 0.1));
    CHECK((exact.hessian - bend).norm() < 1e-6 * exact.hessian.norm());
    CHECK((exact.hessian - exact.hessian.transpose()).norm() < 1e-12 * exact.hessian.norm());
  }
}

TEST_CASE("signed St. Venant-Kirchhoff is plain St. Venant-Kirchhoff down to a stretch of 0.6", "[elasticity]") {
  Random random(13);
  const Material with_sign = of(MaterialModel::signed_st_venant_kirchhoff, 0.35),
                 plain = of(MaterialModel::st_venant_kirchhoff, 0.35);
  for (const Vector3d& s : {Vector3d(1, 1, 1), Vector3d(3, 1, 0.601), Vector3d(0.61, 0.605, 0.6001)}) {
    const Vector12d u = moved(displaced(stretched(random, s)), 0, 0);
    const Derivatives a = at(u, with_sign, true), b = at(u, plain, true);
    CAPTURE(s.transpose());
    CHECK(a.energy == b.energy);
    CHECK(a.gradient == b.gradient);
    CHECK(a.hessian == b.hessian);
  }
  // Continuous where the two laws meet.
  const Matrix3d turn = random.rotation();
  const auto energy = [&](double least) {
    return at(moved(displaced(turn * Vector3d(1.1, 0.9, least).asDiagonal()), 0, 0), with_sign, false);
  };
  CHECK(energy(0.6 + 1e-9).energy == Approx(energy(0.6 - 1e-9).energy).epsilon(1e-7));
  CHECK((energy(0.6 + 1e-9).gradient - energy(0.6 - 1e-9).gradient).norm() < 1e-6 * energy(0.6).gradient.norm());
}

TEST_CASE("every model has Young's modulus and Poisson's ratio at small strain, and no force at rest", "[elasticity]") {
  const auto model = GENERATE(MaterialModel::signed_st_venant_kirchhoff, MaterialModel::stable_neo_hookean,
                              MaterialModel::neo_hookean, MaterialModel::mooney_rivlin, MaterialModel::squared);
  const double nu = GENERATE(0.0, 0.3, 0.45, 0.499);
  Random random(14);
  const Vector12d rest = moved(displaced(random.rotation()), 0, 0);
  const Derivatives d = at(rest, of(model, nu), true),
                    plain = at(rest, of(MaterialModel::st_venant_kirchhoff, nu), true);
  CAPTURE(name_of(model), nu);
  CHECK(d.gradient.norm() < 1e-12 * plain.hessian.norm());
  CHECK(std::abs(d.energy) < 1e-12 * plain.hessian.norm());
  CHECK((d.hessian - plain.hessian).norm() < 1e-11 * plain.hessian.norm());
}

TEST_CASE("only the surviving materials push a mirrored tet back", "[elasticity]") {
  const Vector12d mirrored = moved(displaced(Vector3d(1, 1, -1).asDiagonal()), 0, 0);
  CHECK(at(mirrored, of(MaterialModel::st_venant_kirchhoff, 0.3), false).gradient.norm() < 1e-9);
  for (const auto model : {MaterialModel::signed_st_venant_kirchhoff, MaterialModel::stable_neo_hookean,
                           MaterialModel::neo_hookean, MaterialModel::mooney_rivlin, MaterialModel::squared}) {
    const Derivatives d = at(mirrored, of(model, 0.3), false);
    Vector12d back;  // towards the rest shape
    for (int a = 0; a < 4; ++a) back.segment<3>(3 * a) = -mirrored.segment<3>(3 * a);
    CAPTURE(name_of(model));
    CHECK(d.gradient.dot(back) < -1e-3 * d.gradient.norm() * back.norm());
  }
}

}  // namespace fascia::reference
