// Energy of one linear tet (quadratic_elasticity.h has quadratic ones) with its first and second derivatives, in double
// precision.
//
//   F = I + sum_a u_a b_a^T,  eps = 1/2 (F^T F - I)
//   Psi = lambda/2 tr(eps)^2 + mu eps:eps,  S = lambda tr(eps) I + 2 mu eps
//   energy = V Psi,  gradient_a = V F S b_a
//
// Kelvin-Voigt damping over an implicit Euler step adds damping/h * (eps - eps_n) to eps in S (see
// Material::damping): the incremental potential is V [Psi(eps) + damping/h * Psi(eps - eps_n)]. Laws that reduce the
// damping of drawn-out tets multiply it by damping_share() (sim/material/law.h).
#pragma once
#include <Eigen/Core>

#include "sim/elements/linear_tet.h"
#include "sim/material/material.h"

namespace fascia::reference {

using Matrix12d = Eigen::Matrix<double, 12, 12>;
using Vector12d = Eigen::Matrix<double, 12, 1>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

Eigen::Matrix3d strain_of(const Eigen::Matrix3d& displacement_gradient);  // Green strain of F - I
Vector6d green_strain(const Eigen::Matrix3d& f);                          // xx, yy, zz, yz, xz, xy; tensor shears
/// The same as a matrix, without the rounding of forming F: small strains keep full relative accuracy.
Eigen::Matrix3d green_strain_matrix(const LinearTet& rest, const Corners& displacements);
Eigen::Matrix3d second_piola_stress(const Eigen::Matrix3d& strain,
                                    const Material& material);  // S [Pa] of St. Venant-Kirchhoff

Eigen::Matrix3d first_piola_stress(const Eigen::Matrix3d& f,
                                   const Material& material);  // P = dPsi/dF [Pa], elastic part
/// Von Mises stress [Pa] of the Cauchy stress P F^T / J.
double von_mises(const Eigen::Matrix3d& f, const Eigen::Matrix3d& first_piola);
double von_mises(const Eigen::Matrix3d& f, const Material& material);

template <int nodes>
struct ElementDerivatives {
  double energy = 0;                                    // [J]
  Eigen::Matrix<double, 3 * nodes, 1> gradient;         // dE/du [N], vertex-major
  Eigen::Matrix<double, 3 * nodes, 3 * nodes> hessian;  // [N/m]
};
using Derivatives = ElementDerivatives<4>;
/// Clamps negative eigenvalues to zero.
void clamp_negative_eigenvalues(Eigen::Ref<Eigen::MatrixXd> hessian);

/// `previous_strain` and `damping_over_h` (damping / h, 0 without) define the viscous part. With `project`, negative
/// eigenvalues of the Hessian are clamped to zero (Teran et al. 2005). `with_hessian` false leaves the Hessian unset.
Derivatives elastic(const LinearTet& rest, const Corners& displacements, const Material& material,
                    double damping_over_h, const Eigen::Matrix3d& previous_strain, bool with_hessian, bool project);

}  // namespace fascia::reference
