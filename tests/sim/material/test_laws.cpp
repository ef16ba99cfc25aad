// Laws against closed forms of uniaxial stretch and of other states, at the ends of their ranges and through the table.
// Covers: mooney_rivlin, neo_hookean, squared, st_venant_kirchhoff, stable_neo_hookean
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "sim/material/invariants.h"
#include "sim/material/law.h"

using namespace fascia;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

Material of(MaterialModel model, double nu, double ratio = 0.2) { return {1, nu, 1000, 0, model, ratio}; }

Matrix3d stress(const Material& material, const Vector3d& stretches) {
  return law_of(material.model).density(stretches.asDiagonal(), material, false).first;
}

struct Uniaxial {
  double volume_ratio, nominal_stress;  // [-], [Pa]
};

// Free sides, stretch s along x. The condition of zero stress on the sides is a quadratic equation in J.
Uniaxial uniaxial_neo_hookean(const Material& material, double s) {
  const double mu = material.lame_mu(), lambda = material.lame_lambda(), b = lambda - mu / s;
  const double j = lambda == 0 ? s : (b + std::sqrt(b * b + 4 * lambda * mu)) / (2 * lambda);
  return {j, mu * (s - j / (s * s))};
}

Uniaxial uniaxial_mooney_rivlin(const Material& material, double s) {
  const double mu = material.lame_mu(), r = material.mooney_ratio, c1 = 0.5 * (1 - r) * mu, c2 = 0.5 * r * mu;
  const double d = 2 * (c1 + 2 * c2), k = material.lame_lambda() - 2 * r * mu;
  const double a = 2 * c2 / s + k * s, b = 2 * c1 + 2 * c2 * s * s - k * s;
  const double j = (-b + std::sqrt(b * b + 4 * a * d * s)) / (2 * a), side2 = j / s;
  return {j, 2 * c1 * s + 4 * c2 * s * side2 + (k * (j - 1) - d / j) * side2};
}

}  // namespace

TEST_CASE("uniaxial stretch of neo-Hookean and Mooney-Rivlin bars is that of the closed form", "[laws]") {
  const double nu = GENERATE(0.0, 0.3, 0.45, 0.499), s = GENERATE(0.4, 0.7, 1.0, 1.3, 3.0);
  for (const Material& material : {of(MaterialModel::neo_hookean, nu), of(MaterialModel::mooney_rivlin, nu, 0.2),
                                   of(MaterialModel::mooney_rivlin, nu, 0.7)}) {
    const bool neo = material.model == MaterialModel::neo_hookean;
    if (!neo && material.lame_lambda() < 2 * material.mooney_ratio * material.lame_mu())
      continue;  // another volume term
    const Uniaxial exact = neo ? uniaxial_neo_hookean(material, s) : uniaxial_mooney_rivlin(material, s);
    if (exact.volume_ratio < kLeastVolumeRatio) continue;
    const double side = std::sqrt(exact.volume_ratio / s);
    const Matrix3d p = stress(material, {s, side, side});
    CAPTURE(name_of(material.model), material.mooney_ratio, nu, s, exact.volume_ratio, exact.nominal_stress, p(0, 0),
            p(1, 1));
    CHECK(p(0, 0) == Approx(exact.nominal_stress).epsilon(1e-10).margin(1e-13));
    CHECK(std::abs(p(1, 1)) < 1e-11 * (1 + material.lame_lambda()));
    CHECK(std::abs(p(2, 2)) < 1e-11 * (1 + material.lame_lambda()));
  }
}

TEST_CASE("nearly incompressible bars approach the incompressible forms", "[laws]") {
  for (const double s : {0.6, 0.9, 1.5, 2.5}) {
    const Material neo = of(MaterialModel::neo_hookean, 0.499), mooney = of(MaterialModel::mooney_rivlin, 0.499, 0.4);
    const double mu = neo.lame_mu();
    CAPTURE(s);
    CHECK(uniaxial_neo_hookean(neo, s).nominal_stress == Approx(mu * (s - 1 / (s * s))).epsilon(0.02));
    CHECK(uniaxial_mooney_rivlin(mooney, s).nominal_stress ==
          Approx(mu * (0.6 + 0.4 / s) * (s - 1 / (s * s))).epsilon(0.02));
  }
}

namespace {

// Nominal stresses of the squared law along given principal stretches, from its closed form: w_i = mu I/3 s_i + g1
// J/s_i.
Vector3d squared_stress(const Material& material, const Vector3d& s) {
  const double mu = material.lame_mu(), k = material.lame_lambda() - 2 * mu / 3, j = s.prod(), i = s.squaredNorm();
  const double volume = k >= 0 || j <= 1 ? k * (j - 1) : k * std::log(j) / j, g1 = volume - mu / j;
  return mu * i / 3 * s + g1 * j * s.cwiseInverse();
}

// The stretch across, equal along `free` axes, at which these are free of stress, by bisection.
Vector3d with_free_sides(const Material& material, Vector3d s, const std::vector<int>& free) {
  double low = 0.05, high = 5;
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    for (const int axis : free) s[axis] = middle;
    (squared_stress(material, s)[free[0]] > 0 ? high : low) = middle;
  }
  return s;
}

}  // namespace

TEST_CASE("stresses of the squared law are those of its closed form", "[laws]") {
  const double nu = GENERATE(-0.9, 0.0, 0.15, 0.3, 0.45, 0.499);
  const Material material = of(MaterialModel::squared, nu);
  for (const Vector3d& s : {Vector3d(0.8, 0.8, 0.8), Vector3d(1.2, 1.2, 1.2), Vector3d(2, 0.7, 0.7),
                            Vector3d(0.5, 1.13, 1.13), Vector3d(1.4, 0.9, 0.6), Vector3d(3, 2, 0.1)}) {
    const Vector3d exact = squared_stress(material, s);
    const Matrix3d p = stress(material, s);
    CAPTURE(nu, s.transpose(), exact.transpose());
    CHECK((p.diagonal() - exact).norm() < 1e-10 * exact.norm());
    CHECK((p - Matrix3d(p.diagonal().asDiagonal())).norm() == 0);
  }
}

TEST_CASE("bars, sheets and blocks of the squared law have tabulated stresses", "[laws]") {
  struct Row {
    double nu, stretch;
    std::vector<int> free;
    double nominal, across;  // 0: not compared
  };
  const std::vector<int> sides{1, 2}, thickness{2};
  for (const Row& row :
       {Row{0.3, 0.5, sides, -0.737587, 1.129760}, Row{0.3, 0.8, sides, -0.222214, 1.058819},
        Row{0.3, 1.2, sides, 0.190483, 0.940397}, Row{0.3, 2.0, sides, 1.127117, 0.737157},
        Row{0.49, 0.5, sides, -1.543924, 0}, Row{0.49, 0.8, sides, -0.263166, 0}, Row{0.49, 1.2, sides, 0.175276, 0},
        Row{0.49, 2.0, sides, 0.978935, 0}, Row{0.3, 0.8, thickness, -0.290091, 1.154472},
        Row{0.3, 1.2, thickness, 0.288121, 0.826520}, Row{0.3, 0.8, {}, -0.383949, 0}, Row{0.3, 1.2, {}, 0.680103, 0},
        Row{0.49, 0.8, {}, -5.313244, 0}, Row{0.49, 1.2, {}, 17.303177, 0}}) {
    const Material material = of(MaterialModel::squared, row.nu);
    Vector3d s = Vector3d::Constant(row.stretch);
    if (!row.free.empty()) s = with_free_sides(material, s, row.free);
    const Matrix3d p = stress(material, s);
    CAPTURE(row.nu, row.stretch, row.free.size(), s.transpose(), p(0, 0));
    CHECK(p(0, 0) == Approx(row.nominal).margin(6e-7));
    for (const int axis : row.free) CHECK(std::abs(p(axis, axis)) < 1e-12);
    if (row.across != 0) CHECK(s[row.free[0]] == Approx(row.across).margin(6e-7));
  }
}

TEST_CASE("simple shear of the squared law has the stresses of the closed form", "[laws]") {
  const double nu = GENERATE(0.0, 0.3, 0.49), gamma = GENERATE(0.1, 0.5, 1.5);
  const Material material = of(MaterialModel::squared, nu);
  const double mu = material.lame_mu();
  Matrix3d f = Matrix3d::Identity(), exact = mu * gamma * gamma / 3 * Matrix3d::Identity();
  f(0, 1) = gamma;
  exact(0, 1) = mu * gamma * (1 + gamma * gamma / 3);
  exact(1, 0) = mu * gamma;
  const Matrix3d p = law_of(material.model).density(f, material, false).first;
  CAPTURE(nu, gamma, p, exact);
  CHECK((p - exact).norm() < 1e-10 * exact.norm());
  if (nu == 0.3 && gamma == 0.5) {
    CHECK(p(0, 1) == Approx(0.208333).margin(6e-7));
    CHECK(p(1, 0) == Approx(0.192308).margin(6e-7));
    CHECK(p(0, 0) == Approx(0.032051).margin(6e-7));
  }
}

TEST_CASE("a tet of no size is no trap of the squared law", "[laws]") {
  // Its energy falls from F = 0 in every direction of expansion, and along a line without volume.
  const Material material = of(MaterialModel::squared, 0.3);
  const auto energy = [&](const Vector3d& s) {
    return law_of(material.model).density(s.asDiagonal(), material, false).energy;
  };
  CHECK(energy({0.1, 0.1, 0.1}) < energy({0, 0, 0}));
  CHECK(energy({0.4, 0.4, 0.4}) < energy({0.1, 0.1, 0.1}));
  CHECK(law_of(material.model).density(Matrix3d::Zero(), material, true).second.norm() == 0);
}

TEST_CASE("damping falls with the square of the stretch, of the squared law alone", "[laws]") {
  const Vector3d stretches(2, 0.8, 0.7);
  const Matrix3d strain = 0.5 * (stretches.cwiseAbs2().array() - 1).matrix().asDiagonal().toDenseMatrix();
  CHECK(damping_share(MaterialModel::squared, strain) == Approx(3 / stretches.squaredNorm()));
  CHECK(damping_share(MaterialModel::squared, -0.1 * Matrix3d::Identity()) == 1);  // squeezed
  for (const MaterialModel model : material_models())
    if (model != MaterialModel::squared) CHECK(damping_share(model, strain) == 1);
}

TEST_CASE("viscosity has the lambda of elasticity, up to that of a Poisson's ratio of 0.46", "[laws]") {
  for (const double nu : {-0.4, 0.0, 0.3, 0.45, 0.46}) {
    const Material material = of(MaterialModel::squared, nu);
    CHECK(viscous_lambda(material) == material.lame_lambda());
  }
  for (const double nu : {0.4601, 0.49, 0.499}) {
    const Material material = of(MaterialModel::squared, nu);
    CHECK(viscous_lambda(material) == Approx(11.5 * material.lame_mu()));
  }
}

TEST_CASE("Mooney-Rivlin of ratio 0 is neo-Hookean", "[laws]") {
  Matrix3d f;
  f << 1.2, 0.3, -0.1, 0.05, 0.8, 0.2, -0.3, 0.1, 1.1;
  for (const double scale : {1.0, 0.5, -0.7}) {
    const Density a = law_of(MaterialModel::neo_hookean).density(scale * f, of(MaterialModel::neo_hookean, 0.4), true),
                  b = law_of(MaterialModel::mooney_rivlin)
                          .density(scale * f, of(MaterialModel::mooney_rivlin, 0.4, 0), true);
    CAPTURE(scale);
    CHECK(a.energy == Approx(b.energy));
    CHECK((a.first - b.first).norm() < 1e-13 * a.first.norm());
    CHECK((a.second - b.second).norm() < 1e-13 * a.second.norm());
  }
}

TEST_CASE("derivatives of every law are those of its energy", "[laws]") {
  Matrix3d f;
  f << 1.1, 0.35, -0.2, 0.1, 0.7, 0.25, -0.3, 0.15, 0.95;
  for (const MaterialLaw* law : material_laws())
    for (const double nu : {-0.5, 0.3, 0.49})
      for (const double squeeze : {1.0, 0.3, -0.4}) {
        if (law->model == MaterialModel::st_venant_kirchhoff) continue;  // which is implemented by formulas of strains
        Matrix3d g = f;
        g.col(2) *= squeeze;
        const Material material = of(law->model, nu, 0.6);
        const Density exact = law->density(g, material, true);
        constexpr double kStep = 1e-6;
        Matrix3d slope;
        Matrix9d bend;
        for (int k = 0; k < 9; ++k) {
          Matrix3d after = g, before = g;
          after.data()[k] += kStep;
          before.data()[k] -= kStep;
          const Density high = law->density(after, material, false), low = law->density(before, material, false);
          slope.data()[k] = (high.energy - low.energy) / (2 * kStep);
          bend.col(k) = (flat(high.first) - flat(low.first)) / (2 * kStep);
        }
        CAPTURE(law->name, nu, squeeze, exact.first.norm(), exact.second.norm());
        CHECK((exact.first - slope).norm() < 1e-7 * (exact.first.norm() + exact.second.norm()));
        CHECK((exact.second - bend).norm() < 1e-6 * exact.second.norm());
      }
}

TEST_CASE("energy and stress of tiny strains keep their digits", "[laws]") {
  Matrix3d h;
  h << 3, 1, -2, 4, -1, 2, -3, 1, 2;
  h *= std::ldexp(1, -26);  // F = I + H has all of its digits
  const Matrix3d f = Matrix3d::Identity() + h, strain = 0.5 * (h + h.transpose());
  for (const MaterialLaw* law : material_laws()) {
    const Material material = of(law->model, 0.3, 0.6);
    const double lambda = material.lame_lambda(), mu = material.lame_mu();
    const double linear = 0.5 * lambda * strain.trace() * strain.trace() + mu * strain.squaredNorm();
    const Density density = law->density(f, material, false);
    CAPTURE(law->name, density.energy, linear);
    if (!law->of_strain) CHECK(density.energy == Approx(linear).epsilon(1e-6));  // the others have formulas of strains
    CHECK((density.first - lambda * strain.trace() * Matrix3d::Identity() - 2 * mu * strain).norm() <
          1e-6 * density.first.norm());
  }
}

TEST_CASE("energies with a logarithm stay finite, and grow through J = 0", "[laws]") {
  for (const MaterialModel model : {MaterialModel::neo_hookean, MaterialModel::mooney_rivlin, MaterialModel::squared})
    for (const double nu : {-0.5, 0.0, 0.3, 0.49}) {
      double before = 0;
      for (const double s : {0.15, 0.05, 0.0, -0.2, -0.6, -1.0}) {
        const double energy = law_of(model).density(Vector3d(1, 1, s).asDiagonal(), of(model, nu), false).energy;
        CAPTURE(name_of(model), nu, s, before, energy);
        CHECK(std::isfinite(energy));
        CHECK(energy > before);
        before = energy;
      }
    }
}

TEST_CASE("the table of laws has every model once, with a unique name", "[laws]") {
  std::set<std::string> names;
  for (const MaterialLaw* law : material_laws()) {
    CHECK(names.insert(law->name).second);
    CHECK(&law_of(law->model) == law);
    CHECK(find_material_model(law->name) == law->model);
    CHECK(std::string(law->label) != "");
    CHECK(std::string(law->help) != "");
  }
  CHECK(names.size() == material_models().size());
  CHECK(reads(MaterialModel::mooney_rivlin, "mooney_ratio"));
  CHECK_FALSE(reads(MaterialModel::neo_hookean, "mooney_ratio"));
  CHECK(reads(MaterialModel::neo_hookean, "young_modulus"));
}
