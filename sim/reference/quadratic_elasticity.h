// Energy of one quadratic tet with its first and second derivatives, in double precision.
//
//   energy = V [ mean Psi(F_q) + K/2 theta^2 ],  theta = mean theta(F_q)          Psi, K: volume_split()
//   gradient_n = V/4 sum_q (P_q + K theta dtheta/dF_q) grad N_n(q)
//   Hessian = V/4 sum_q [d2Psi/dF_q^2 + K theta d2theta/dF_q^2] + V K w w^T,  w = dtheta/du
//
// (sim/elements/quadratic_tet.h has the sources.) Kelvin-Voigt damping is that of elasticity.h with the same split:
//
//   V damping/h [ mu mean |eps_q - eps_q,n|^2 + lambda/2 (mean tr (eps_q - eps_q,n))^2 ]
//
// where a negative lambda stays pointwise. damping_share() is that of the mean of eps_n over the element.
#pragma once
#include <array>
#include <vector>

#include "sim/elements/quadratic_tet.h"
#include "sim/reference/elasticity.h"

namespace fascia::reference {

using PointStrains = std::array<Eigen::Matrix3d, QuadraticTet::kPoints>;

PointStrains no_strains();  // zeros
PointStrains green_strains(const QuadraticTet& rest, const QuadraticTet::Nodes& displacements);

/// Arguments as of elastic() of a linear tet.
ElementDerivatives<QuadraticTet::kNodes> elastic(const QuadraticTet& rest, const QuadraticTet::Nodes& displacements,
                                                 const Material& material, double damping_over_h,
                                                 const PointStrains& previous_strains, bool with_hessian, bool project);

/// First Piola stresses [Pa] at barycentric coordinates, elastic part, with the averaged change of volume: the
/// pointwise one is useless where Poisson's ratio is near 0.5.
std::vector<Eigen::Matrix3d> first_piola_stresses(const QuadraticTet& rest, const QuadraticTet::Nodes& displacements,
                                                  const Material& material,
                                                  const std::vector<Eigen::Vector4d>& barycentric);
/// The same at the centroid.
Eigen::Matrix3d first_piola_stress(const QuadraticTet& rest, const QuadraticTet::Nodes& displacements,
                                   const Material& material);

/// Smallest and largest J over the points and, where `with_corners`, the corners, which turn inside out first.
struct VolumeRatios {
  double min, max;
};
VolumeRatios volume_ratios(const QuadraticTet& rest, const QuadraticTet::Nodes& displacements, bool with_corners);

}  // namespace fascia::reference
