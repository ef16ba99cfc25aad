// Compressible Mooney-Rivlin material (Ciarlet 1988, section 4.10; Holzapfel 2000, eq. 6.147):
//   Psi = c1 (I1 - 3) + c2 (I2 - 3) - 2 (c1 + 2 c2) log J + k/2 (J - 1)^2, I1 = |F|^2, I2 = |cof F|^2
//   c1 = (1 - r) mu/2, c2 = r mu/2, k = lambda - 2 r mu, r = Material::mooney_ratio
// Small strains have Lame's parameters for any r; r = 0 is neo_hookean. invariants.h defines how log J and the last
// term are continued.
#include <Eigen/LU>

#include "sim/material/invariants.h"
#include "sim/material/law.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;

Density mooney_rivlin_density(const Matrix3d& f, const Material& material, bool with_second) {
  const double mu = material.lame_mu(), ratio = material.mooney_ratio;
  const double c1 = 0.5 * (1 - ratio) * mu, c2 = 0.5 * ratio * mu, d = 2 * (c1 + 2 * c2);
  const FromRest r = from_rest(f);
  const Matrix3d identity = Matrix3d::Identity(), c = identity + r.cofactor;
  const OfVolume above = above_extended_log(r.volume),
                 volume = volume_term(1 + r.volume, material.lame_lambda() - 2 * ratio * mu);
  const double g1 = d * above.first + volume.first, g2 = d * above.second + volume.second;
  Density density;
  density.energy = 2 * c1 * (0.5 * r.h.squaredNorm() - r.higher) +
                   2 * c2 * (0.5 * r.cofactor.squaredNorm() - r.higher - r.h.determinant()) + d * above.value +
                   volume.value;
  // F x C - 2 C: the identities cancel.
  const Matrix3d second = (r.h.trace() + r.cofactor.trace()) * identity - r.h.transpose() - r.cofactor.transpose() +
                          tensor_cross(r.h, r.cofactor) - 2 * r.cofactor;
  density.first = 2 * c1 * (r.h - r.cofactor) + 2 * c2 * second + g1 * c;
  if (!with_second) return density;
  for (int k = 0; k < 9; ++k) {
    Matrix3d e = Matrix3d::Zero();
    e(k % 3, k / 3) = 1;
    const Matrix3d change = tensor_cross(f, e);  // of the cofactors
    Eigen::Map<Matrix3d>(density.second.col(k).data()) = 2 * c1 * e +
                                                         2 * c2 * (tensor_cross(e, c) + tensor_cross(f, change)) +
                                                         g2 * c(k % 3, k / 3) * c + (g1 - d) * change;
  }
  return density;
}

}  // namespace

const MaterialLaw kMooneyRivlin{
    MaterialModel::mooney_rivlin,
    "mooney_rivlin",
    "Mooney-Rivlin",
    "Rubber of two constants, compressible (Ciarlet 1988): mooney_ratio is the share of the second one. Stiffer than "
    "neo-Hookean under compression and biaxial tension. For two_level and vertex_descent.",
    "mooney_ratio",
    false,
    nullptr,
    mooney_rivlin_density,
    [](const Material& m) { return m.lame_lambda() - 2 * m.mooney_ratio * m.lame_mu(); },
    volume_change};

}  // namespace fascia
