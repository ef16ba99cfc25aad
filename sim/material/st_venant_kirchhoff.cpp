#include "sim/material/st_venant_kirchhoff.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "sim/material/invariants.h"
#include "sim/material/signed_svd.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Whether St. Venant-Kirchhoff's own formulas apply: all singular values are at least kLeastStretch and none is
// negative.
bool upright(const Matrix3d& f) {
  Matrix3d c = f.transpose() * f;
  c.diagonal().array() -= kLeastStretch * kLeastStretch;
  return c(0, 0) > 0 && c(0, 0) * c(1, 1) > c(0, 1) * c(0, 1) && c.determinant() > 0 &&
         f.determinant() > 0;  // Sylvester's criterion
}

/// The strains e(s) of the signed singular values with their first and second derivatives by s.
struct PrincipalStrains {
  explicit PrincipalStrains(const Matrix3d& f) : svd(signed_svd(f)) {
    for (int i = 0; i < 3; ++i) {
      const double s = svd.s[i];
      const bool straight = s < kLeastStretch;
      slope[i] = straight ? kLeastStretch : s;
      bend[i] = straight ? 0 : 1;
      e[i] = straight ? 0.5 * (kLeastStretch * kLeastStretch - 1) + kLeastStretch * (s - kLeastStretch)
                      : 0.5 * (s * s - 1);
    }
  }
  SignedSvd svd;
  Vector3d e, slope, bend;
};

/// The second derivative by F of a function of the signed singular values s whose derivatives by s are `w` and
/// `by_stretch`. It acts on U^T dF V: on the diagonal it is that by s; on pairs (i, j) it is (w_i - w_j) / (s_i - s_j)
/// on their symmetric and (w_i + w_j) / (s_i + s_j) on their antisymmetric part.
Matrix9d second_derivative(const SignedSvd& svd, const Vector3d& w, const Matrix3d& by_stretch) {
  const auto mode = [&](int i, int j) -> Matrix3d { return svd.u.col(i) * svd.v.col(j).transpose(); };
  Matrix9d second = Matrix9d::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      second += by_stretch(i, j) * flat(mode(i, i)) * flat(mode(j, j)).transpose();
      if (i >= j) continue;
      const double difference = svd.s[i] - svd.s[j], sum = svd.s[i] + svd.s[j];
      const double symmetric = difference > 1e-8 ? (w[i] - w[j]) / difference : by_stretch(i, i) - by_stretch(i, j);
      const double antisymmetric = (w[i] + w[j]) / std::max(sum, 1e-8);
      const Matrix3d even = (mode(i, j) + mode(j, i)) / std::sqrt(2.0),
                     odd = (mode(i, j) - mode(j, i)) / std::sqrt(2.0);
      second += symmetric * flat(even) * flat(even).transpose() + antisymmetric * flat(odd) * flat(odd).transpose();
    }
  return second;
}

/// The sum of the strains e(s): the trace of the Green strain where no direction is compressed below kLeastStretch.
Dilatation signed_strain(const Matrix3d& f, bool with_second) {
  const PrincipalStrains strains(f);
  Dilatation sum{strains.e.sum(), strains.svd.u * strains.slope.asDiagonal() * strains.svd.v.transpose()};
  if (with_second) sum.second = second_derivative(strains.svd, strains.slope, strains.bend.asDiagonal());
  return sum;
}

double lame_lambda(const Material& material) { return material.lame_lambda(); }

}  // namespace

// St. Venant-Kirchhoff's law with the strains e(s) = (s^2 - 1) / 2 of the signed singular values, continued by its
// tangent below kLeastStretch (after Irving, Teran, Fedkiw 2004).
Density signed_st_venant_kirchhoff_density(const Matrix3d& f, const Material& material, bool with_second) {
  const double lambda = material.lame_lambda(), mu = material.lame_mu();
  const PrincipalStrains strains(f);
  const Vector3d& e = strains.e;
  const Vector3d stress = lambda * e.sum() * Vector3d::Ones() + 2 * mu * e, w = strains.slope.cwiseProduct(stress);
  Density density;
  density.energy = 0.5 * lambda * e.sum() * e.sum() + mu * e.squaredNorm();
  density.first = strains.svd.u * w.asDiagonal() * strains.svd.v.transpose();
  if (!with_second) return density;
  Matrix3d by_stretch = lambda * strains.slope * strains.slope.transpose();
  by_stretch.diagonal() += 2 * mu * strains.slope.cwiseAbs2() + strains.bend.cwiseProduct(stress);
  density.second = second_derivative(strains.svd, w, by_stretch);
  return density;
}

const MaterialLaw kSignedStVenantKirchhoff{MaterialModel::signed_st_venant_kirchhoff,
                                           "signed_st_venant_kirchhoff",
                                           "St. Venant-Kirchhoff",
                                           "Linear in the Green strain; goes on resisting where it is compressed below "
                                           "60 % or turned inside out, and so comes back.",
                                           nullptr,
                                           true,
                                           upright,
                                           signed_st_venant_kirchhoff_density,
                                           lame_lambda,
                                           signed_strain};

const MaterialLaw kStVenantKirchhoff{
    MaterialModel::st_venant_kirchhoff,
    "st_venant_kirchhoff",
    "St. Venant-Kirchhoff, plain",
    "Linear in the Green strain to the end: softens under strong compression, and may stay inside out.",
    nullptr,
    true,
    [](const Matrix3d&) { return true; },
    signed_st_venant_kirchhoff_density,
    lame_lambda,
    [](const Matrix3d& f, bool) {
      return Dilatation{0.5 * (f.squaredNorm() - 3), f, Matrix9d::Identity()};
    }};

}  // namespace fascia
