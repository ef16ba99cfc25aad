#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "sim/material/invariants.h"
#include "sim/material/law.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

// Smith, de Goes, Kim 2018, eq. 14, with their Lame parameters (section 3.4), so that small strains have Young's
// modulus and Poisson's ratio: Psi = mu/2 (I - 3) + lambda/2 (J - alpha)^2 - mu/2 log(I + 1), I = |F|^2,
// alpha = 1 + 3/4 mu/lambda, minus its value at rest.
Density stable_neo_hookean_density(const Matrix3d& f, const Material& material, bool with_second) {
  const double mu = 4.0 / 3.0 * material.lame_mu(), lambda = material.lame_lambda() + 5.0 / 6.0 * material.lame_mu();
  const FromRest r = from_rest(f);
  const double i = 3 + r.stretch, of_volume = lambda * r.volume - 0.75 * mu;  // lambda (J - alpha)
  const Matrix3d c = Matrix3d::Identity() + r.cofactor;
  Density density;
  density.energy =
      mu * (0.375 * r.h.squaredNorm() - 0.75 * r.higher + 0.125 * r.stretch - 0.5 * std::log1p(0.25 * r.stretch)) +
      0.5 * lambda * r.volume * r.volume;
  density.first = 0.75 * mu * (r.h - r.cofactor) + 0.25 * mu * r.stretch / (i + 1) * f + lambda * r.volume * c;
  if (!with_second) return density;
  density.second = mu * (1 - 1 / (i + 1)) * Matrix9d::Identity() +
                   2 * mu / ((i + 1) * (i + 1)) * flat(f) * flat(f).transpose() +
                   lambda * flat(c) * flat(c).transpose();
  for (int k = 0; k < 3; ++k) {  // of J: columns of F crossed with each other
    const Matrix3d cross = of_volume * cross_matrix(f.col(k));
    const int before = (k + 2) % 3, after = (k + 1) % 3;
    density.second.block<3, 3>(3 * before, 3 * after) += cross;
    density.second.block<3, 3>(3 * after, 3 * before) -= cross;
  }
  return density;
}

}  // namespace

const MaterialLaw kStableNeoHookean{MaterialModel::stable_neo_hookean,
                                    "stable_neo_hookean",
                                    "Neo-Hookean, stable",
                                    "Rubber (Smith, de Goes, Kim 2018): softer than the others in tension, stiffer in "
                                    "compression, comes back from inside out. For two_level and vertex_descent.",
                                    nullptr,
                                    false,
                                    nullptr,
                                    stable_neo_hookean_density,
                                    [](const Material& m) { return m.lame_lambda(); },
                                    volume_change};

}  // namespace fascia
