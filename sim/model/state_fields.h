// The fields that an export contains besides positions.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace fascia {

/// The fields at one time. Vertex arrays are [mesh.positions.size()], tet arrays [mesh.tets.size()].
struct StateFields {
  std::vector<Eigen::Vector3d> displacement;              // [m]
  std::vector<Eigen::Vector3d> velocity;                  // [m/s]
  std::vector<Eigen::Matrix<double, 6, 1>> green_strain;  // xx, yy, zz, yz, xz, xy, tensor shears [-]
  std::vector<double> von_mises;                          // of the Cauchy stress [Pa]
  std::vector<double> det_f;                              // J [-], exported as "J"
};

}  // namespace fascia
