// Rotations as scenes state them.
#pragma once
#include <Eigen/Geometry>
#include <numbers>

namespace fascia {

/// About x, then y, then z, by degrees.
inline Eigen::Matrix3d rotation_of(const Eigen::Vector3d& angles_deg) {
  const auto about = [&](int axis) {
    return Eigen::AngleAxisd(angles_deg[axis] * (std::numbers::pi / 180), Eigen::Vector3d::Unit(axis))
        .toRotationMatrix();
  };
  return about(2) * about(1) * about(0);
}

}  // namespace fascia
