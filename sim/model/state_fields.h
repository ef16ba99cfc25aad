// The fields that an export contains besides positions.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

/// A tool as triangles, where it is at that time.
struct ToolSurface {
  std::string name;
  std::vector<Eigen::Vector3d> positions;  // [m]
  std::vector<Triangle> triangles;         // wound outward
};

/// The fields at one time. Vertex arrays are [mesh.positions.size()], tet arrays [mesh.tets.size()].
struct StateFields {
  std::vector<Eigen::Vector3d> displacement;              // [m]
  std::vector<Eigen::Vector3d> velocity;                  // [m/s]
  std::vector<Eigen::Matrix<double, 6, 1>> green_strain;  // xx, yy, zz, yz, xz, xy, tensor shears [-]
  std::vector<double> von_mises;                          // of the Cauchy stress [Pa]
  std::vector<double> det_f;                              // J [-], exported as "J"
  // Of the recovered Cauchy stress at vertices (sim/accuracy/nodal_stress.h)
  std::vector<Eigen::Matrix<double, 6, 1>> recovered_stress;  // xx, yy, zz, yz, xz, xy [Pa]
  std::vector<double> recovered_von_mises;                    // [Pa]
  // In scenes with tools
  std::vector<Eigen::Vector3d> contact_force;  // of the tools on the tissue, at its vertices [N]
  std::vector<double> contact_gap;             // signed distance to the nearest tool [m]; NaN inside the tissue
  std::vector<ToolSurface> tools;
};

}  // namespace fascia
