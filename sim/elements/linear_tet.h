// The linear tetrahedron. Displacements are interpolated between four corners, so the whole tet has one deformation
// gradient.
//
//   F = I + sum_a u_a b_a^T
//
// with b_a the gradient of corner a's shape function at rest.
#pragma once
#include <Eigen/Core>
#include <array>

namespace fascia {

using Corners = std::array<Eigen::Vector3d, 4>;

/// The constants of a tet at rest.
struct LinearTet {
  explicit LinearTet(const Corners& rest_positions);

  Eigen::Matrix<double, 3, 4> gradients;  // b_a, columns [1/m]
  double volume;                          // V [m^3]

  /// F - I from differences of displacements, so that neither the identity nor a common translation costs accuracy.
  Eigen::Matrix3d displacement_gradient(const Corners& displacements) const;
  Eigen::Matrix3d deformation_gradient(const Corners& displacements) const;
};

}  // namespace fascia
