// Squared neo-Hookean material: the first two terms of Yeoh 1993, eq. 3, with c2 = c1/6, and a logarithmic volume term:
//   Psi = c1 (I1 - 3) + c2 (I1 - 3)^2 - mu log J + k/2 (J - 1)^2 = mu/12 (I1^2 - 9) - mu log J + k/2 (J - 1)^2
//   c1 = mu/2, k = lambda - 2 mu/3, I1 = |F|^2
// with Lame's parameters of small strains. The force of the first term vanishes with F itself and grows with its cube:
// neither a tet of no size nor one drawn out has a minimum of the energy. invariants.h defines how log J and the last
// term are continued.
#include "sim/material/invariants.h"
#include "sim/material/law.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;

Density squared_density(const Matrix3d& f, const Material& material, bool with_second) {
  const double mu = material.lame_mu();
  const FromRest r = from_rest(f);
  const Matrix3d c = Matrix3d::Identity() + r.cofactor;
  const OfVolume above = above_extended_log(r.volume, kLeastVolumeRatioOfSquared),
                 volume = volume_term(1 + r.volume, material.lame_lambda() - 2 * mu / 3);
  const double g1 = mu * above.first + volume.first, g2 = mu * above.second + volume.second;
  Density density;
  density.energy = mu * (0.5 * r.h.squaredNorm() - r.higher + above.value + r.stretch * r.stretch / 12) + volume.value;
  density.first = mu * (r.h - r.cofactor) + mu * r.stretch / 3 * f + g1 * c;
  if (!with_second) return density;
  for (int k = 0; k < 9; ++k) {
    Matrix3d e = Matrix3d::Zero();
    e(k % 3, k / 3) = 1;
    Eigen::Map<Matrix3d>(density.second.col(k).data()) = mu * (1 + r.stretch / 3) * e +
                                                         2 * mu / 3 * f(k % 3, k / 3) * f + g2 * c(k % 3, k / 3) * c +
                                                         (g1 - mu) * tensor_cross(f, e);
  }
  return density;
}

}  // namespace

const MaterialLaw kSquared{MaterialModel::squared,
                           "squared",
                           "Neo-Hookean, squared",
                           "Soft tissue: resists compression and tension ever more, and comes back from inside out "
                           "(Yeoh 1993, two terms). For two_level and vertex_descent.",
                           nullptr,
                           false,
                           nullptr,
                           squared_density,
                           [](const Material& m) { return m.lame_lambda() - 2 * m.lame_mu() / 3; },
                           volume_change,
                           true};

}  // namespace fascia
