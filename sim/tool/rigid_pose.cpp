#include "sim/tool/rigid_pose.h"

#include <Eigen/Geometry>
#include <numbers>

namespace fascia {

Eigen::Matrix3d rotation_of(const Eigen::Vector3d& angles_deg) {
  const Eigen::Vector3d angles = angles_deg * (std::numbers::pi / 180);
  const auto about = [&](int k) { return Eigen::AngleAxisd(angles[k], Eigen::Vector3d::Unit(k)); };
  return (about(2) * about(1) * about(0)).toRotationMatrix();
}

RigidPose between(const RigidPose& from, const RigidPose& to, double share) {
  if (share >= 1 || from == to) return to;
  const Eigen::AngleAxisd turn(to.axes * from.axes.transpose());
  const Eigen::Matrix3d part = Eigen::AngleAxisd(share * turn.angle(), turn.axis()).toRotationMatrix();
  return {part * from.axes, (1 - share) * from.origin + share * to.origin};
}

}  // namespace fascia
