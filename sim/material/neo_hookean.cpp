// Compressible neo-Hookean material (Simo, Pister 1984; Pence, Gou 2015):
//   Psi = mu/2 (I1 - 3) - mu log J + lambda/2 (J - 1)^2, I1 = |F|^2
// with Lame's parameters of small strains. invariants.h defines how log J and the last term are continued.
#include "sim/material/invariants.h"
#include "sim/material/law.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;

Density neo_hookean_density(const Matrix3d& f, const Material& material, bool with_second) {
  const double mu = material.lame_mu();
  const FromRest r = from_rest(f);
  const Matrix3d c = Matrix3d::Identity() + r.cofactor;
  const OfVolume above = above_extended_log(r.volume), volume = volume_term(1 + r.volume, material.lame_lambda());
  const double g1 = mu * above.first + volume.first, g2 = mu * above.second + volume.second;
  Density density;
  density.energy = mu * (0.5 * r.h.squaredNorm() - r.higher + above.value) + volume.value;
  density.first = mu * (r.h - r.cofactor) + g1 * c;
  if (!with_second) return density;
  for (int k = 0; k < 9; ++k) {
    Matrix3d e = Matrix3d::Zero();
    e(k % 3, k / 3) = 1;
    Eigen::Map<Matrix3d>(density.second.col(k).data()) =
        mu * e + g2 * c(k % 3, k / 3) * c + (g1 - mu) * tensor_cross(f, e);
  }
  return density;
}

}  // namespace

const MaterialLaw kNeoHookean{MaterialModel::neo_hookean,
                              "neo_hookean",
                              "Neo-Hookean",
                              "Rubber, compressible (Simo, Pister 1984): softens in tension, resists compression ever "
                              "more. For two_level and vertex_descent.",
                              nullptr,
                              false,
                              nullptr,
                              neo_hookean_density,
                              [](const Material& m) { return m.lame_lambda(); },
                              volume_change};

}  // namespace fascia
