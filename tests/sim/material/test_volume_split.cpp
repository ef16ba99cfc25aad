// The parts of a law for elements that average their change of volume.
// Covers: laws, invariants
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "sim/material/law.h"
#include "sim/material/symmetric_eigen.h"

using namespace fascia;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

// Stretches with and without compression below kLeastStretch, flat and inside out.
const std::vector<Vector3d> kStretches = {{1, 1, 1},       {1.3, 1.1, 0.9}, {1.2, 0.8, 0.7}, {0.7, 0.65, 0.62},
                                          {2, 1.5, 1.2},   {1.2, 0.9, 0.3}, {0.5, 0.4, 0.3}, {1.1, 1.0, -0.5},
                                          {1.2, 0.9, 0.0}, {0.3, 0.2, 0.1}};

Matrix3d turned(const Vector3d& stretches) {
  const Matrix3d left = Eigen::AngleAxisd(0.8, Vector3d(1, 2, -1).normalized()).toRotationMatrix(),
                 right = Eigen::AngleAxisd(-1.3, Vector3d(0.5, -1, 2).normalized()).toRotationMatrix();
  return left * stretches.asDiagonal() * right;
}

Material tissue_of(MaterialModel model, double nu) { return {1e5, nu, 1000, 0, model, 0.3}; }

}  // namespace

TEST_CASE("the two parts of every law add up to it, with their derivatives", "[laws]") {
  const MaterialModel model = GENERATE(from_range(material_models()));
  const double nu = GENERATE(-0.5, 0.0, 0.1, 0.3, 0.45, 0.499);
  const Material material = tissue_of(model, nu);
  const MaterialLaw& law = law_of(model);
  const VolumeSplit split = volume_split(material);
  REQUIRE(split.bulk >= 0);
  CHECK(split.pointwise.lame_mu() == Approx(material.lame_mu()).epsilon(1e-14));
  CHECK(split.pointwise.lame_lambda() + split.bulk ==
        Approx(material.lame_lambda()).epsilon(1e-12).margin(1e-12 * material.lame_mu()));
  for (const Vector3d& s : kStretches) {
    // The plain law has the density of the signed one, and its own measure of the change of volume above 0.6 only.
    if (model == MaterialModel::st_venant_kirchhoff && s.minCoeff() < 0.6) continue;
    const Matrix3d f = turned(s);
    const Density whole = law.density(f, material, true), part = law.density(f, split.pointwise, true);
    const Dilatation theta = law.dilatation(f, true);
    const double size = material.lame_mu() + split.bulk;
    const double energy = part.energy + 0.5 * split.bulk * theta.value * theta.value;
    const Matrix3d first = part.first + split.bulk * theta.value * theta.first;
    const Matrix9d second =
        part.second + split.bulk * (theta.value * theta.second + flat(theta.first) * flat(theta.first).transpose());
    CAPTURE(name_of(model), nu, s.transpose(), split.bulk, whole.energy, energy);
    CHECK(std::abs(whole.energy - energy) < 1e-13 * (size + std::abs(whole.energy)));
    CHECK((whole.first - first).norm() < 1e-13 * (size + whole.first.norm()));
    CHECK((whole.second - second).norm() < 1e-12 * (size + whole.second.norm()));
  }
}

TEST_CASE("measures of the change of volume are zero at rest and have the derivatives of their differences", "[laws]") {
  const MaterialModel model = GENERATE(from_range(material_models()));
  const MaterialLaw& law = law_of(model);
  CHECK(std::abs(law.dilatation(Matrix3d::Identity(), false).value) < 1e-15);
  constexpr double kStep = 1e-6;
  for (const Vector3d& s : kStretches) {
    const Matrix3d f = turned(s);
    const Dilatation exact = law.dilatation(f, true);
    Matrix3d slope;
    Matrix9d bend;
    for (int k = 0; k < 9; ++k) {
      Matrix3d step = Matrix3d::Zero();
      step(k % 3, k / 3) = kStep;
      const Dilatation after = law.dilatation(f + step, false), before = law.dilatation(f - step, false);
      slope(k % 3, k / 3) = (after.value - before.value) / (2 * kStep);
      bend.col(k) = (flat(after.first) - flat(before.first)) / (2 * kStep);
    }
    CAPTURE(name_of(model), s.transpose(), exact.value, exact.first, slope);
    CHECK((exact.first - slope).norm() < 1e-8);
    CHECK((exact.second - bend).norm() < 1e-8 * (1 + exact.second.norm()));
  }
}

TEST_CASE("the pointwise part of every law is stable at rest, whichever Poisson's ratio the whole has", "[laws]") {
  const MaterialModel model = GENERATE(from_range(material_models()));
  for (const double nu : {-0.5, 0.0, 0.1, 0.3, 0.45, 0.499}) {
    const Material material = tissue_of(model, nu);
    const Material part = volume_split(material).pointwise;
    const Density at_rest = law_of(model).density(Matrix3d::Identity(), part, true);
    // Rotations cost nothing, every strain at least a share of mu that the Poisson's ratio of the part leaves.
    const Eigen::VectorXd stiffness = symmetric_eigen(at_rest.second).values;
    CAPTURE(name_of(model), nu, part.poisson_ratio, stiffness.transpose());
    CHECK(at_rest.first.norm() < 1e-14 * material.lame_mu());
    CHECK(std::abs(stiffness[2]) < 1e-12 * material.lame_mu());
    CHECK(stiffness[3] > 0.4 * material.lame_mu());
    CHECK(part.poisson_ratio <= 0.2 + 1e-12);  // at most that of squared
  }
}

TEST_CASE("laws average all of lambda that leaves no negative volume term", "[laws]") {
  const auto bulk = [](MaterialModel model, double nu) { return volume_split(tissue_of(model, nu)).bulk; };
  const Material tissue = tissue_of(MaterialModel::squared, 0.45);
  const double lambda = tissue.lame_lambda(), mu = tissue.lame_mu();
  CHECK(bulk(MaterialModel::st_venant_kirchhoff, 0.45) == lambda);
  CHECK(bulk(MaterialModel::signed_st_venant_kirchhoff, 0.45) == lambda);
  CHECK(bulk(MaterialModel::neo_hookean, 0.45) == lambda);
  CHECK(bulk(MaterialModel::stable_neo_hookean, 0.45) == lambda);
  CHECK(bulk(MaterialModel::mooney_rivlin, 0.45) == Approx(lambda - 0.6 * mu).epsilon(1e-14));
  CHECK(bulk(MaterialModel::squared, 0.45) == Approx(lambda - 2 * mu / 3).epsilon(1e-14));
  for (const MaterialModel model : material_models()) {  // nothing where lambda is negative
    CHECK(bulk(model, -0.2) == 0);
    CHECK(volume_split(tissue_of(model, -0.2)).pointwise == tissue_of(model, -0.2));
  }
  CHECK(bulk(MaterialModel::squared, 0.19) == 0);
}
