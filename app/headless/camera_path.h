// The camera that moves by itself in pictures without a window: along the keys of a scene, and on a turntable.
#pragma once
#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace fascia {

class CameraPath {
 public:
  /// Keys of `motion`, of which the first follows `start`. `where`: names the scene in errors. Throws Error for a key
  /// whose eye is at its target.
  CameraPath(const CameraMotion& motion, const CameraSettings& start, const std::string& where);

  /// The camera at a simulated time [s]: at the first key before it, at the last one behind it. Between them it moves
  /// around the target, with the logarithm of the distance, on monotone cubics (Fritsch and Butland 1984): it never
  /// goes beyond a key, and stands still between equal ones. Without `smooth` on straight lines.
  CameraSettings at(double time) const;
  double end() const { return times_.back(); }  // time of the last key [s]

 private:
  // Angles around the target [degrees], logarithm of the distance, target [m], lens [degrees]
  using Pose = Eigen::Matrix<double, 7, 1>;

  CameraSettings camera_of(const Pose& pose) const;

  Eigen::Vector3d up_;
  bool smooth_;
  std::vector<double> times_;
  std::vector<Pose> poses_, slopes_;  // at the keys; slopes per second
};

/// A turn of the camera about its target and `up`, to the right.
CameraSettings turned(const CameraSettings& camera, double degrees);

}  // namespace fascia
