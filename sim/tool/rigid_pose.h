// Where a rigid thing is: from its own axes to those of the scene. The axes may be mirrored.
#pragma once
#include <Eigen/Core>

namespace fascia {

struct RigidPose {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // orthogonal
  Eigen::Vector3d origin{0, 0, 0};                     // [m]

  Eigen::Vector3d to_scene(const Eigen::Vector3d& local) const { return axes * local + origin; }
  Eigen::Vector3d to_local(const Eigen::Vector3d& point) const { return axes.transpose() * (point - origin); }
  bool operator==(const RigidPose&) const = default;
};

/// The pose of a thing that has the pose `inner` in the axes of `outer`.
inline RigidPose composed(const RigidPose& outer, const RigidPose& inner) {
  return {outer.axes * inner.axes, outer.to_scene(inner.origin)};
}

/// On the way from one pose to another of the same thing: straight, with one rotation about one axis.
RigidPose between(const RigidPose& from, const RigidPose& to, double share);

}  // namespace fascia
