#include "sim/tool/rigid_pose.h"

#include <Eigen/Geometry>

namespace fascia {

RigidPose between(const RigidPose& from, const RigidPose& to, double share) {
  if (share >= 1 || from == to) return to;
  const Eigen::AngleAxisd turn(to.axes * from.axes.transpose());
  const Eigen::Matrix3d part = Eigen::AngleAxisd(share * turn.angle(), turn.axis()).toRotationMatrix();
  return {part * from.axes, (1 - share) * from.origin + share * to.origin};
}

}  // namespace fascia
