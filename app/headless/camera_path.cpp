#include "app/headless/camera_path.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "render/view/camera.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kSteepest = 89;  // [degrees] of the eye: closer to `up` the picture has no right-hand side
enum { kAzimuth, kElevation, kDistance, kTarget, kLens = kTarget + 3 };

// Slope at a key between two intervals with these slopes and lengths: 0 where they change sign, else their weighted
// harmonic mean.
double monotone_slope(double before, double after, double h0, double h1) {
  if (before * after <= 0) return 0;
  const double w0 = 2 * h1 + h0, w1 = h1 + 2 * h0;
  return (w0 + w1) / (w0 / before + w1 / after);
}

}  // namespace

CameraPath::CameraPath(const CameraMotion& motion, const CameraSettings& start, const std::string& where)
    : up_(start.up), smooth_(motion.smooth) {
  const Eigen::Matrix3d axes = standing_axes(up_);
  const auto look_from = [&](Pose& pose, const Vector3d& eye) {
    const Vector3d view = axes.transpose() * (eye - pose.segment<3>(kTarget));  // right, up, front
    const double across = std::hypot(view.x(), view.z()), before = pose[kAzimuth];
    // The shorter turn from the key before; straight above or below none.
    if (across > 1e-9 * view.norm()) {
      const double angle = std::atan2(view.x(), view.z()) / kRadians;
      pose[kAzimuth] = before + std::remainder(angle - before, 360.0);
    }
    pose[kElevation] = std::clamp(std::atan2(view.y(), across) / kRadians, -kSteepest, kSteepest);
    pose[kDistance] = std::log(view.norm());
  };
  Pose pose = Pose::Zero();
  pose.segment<3>(kTarget) = start.target;
  pose[kLens] = start.fov_deg;
  look_from(pose, start.eye);
  const Pose first = pose;
  for (std::size_t k = 0; k < motion.keys.size(); ++k) {
    const CameraKey& key = motion.keys[k];
    if (key.target) pose.segment<3>(kTarget) = *key.target;
    if (key.orbit_deg) pose[kAzimuth] = first[kAzimuth] + *key.orbit_deg;
    if (key.elevation_deg) pose[kElevation] = *key.elevation_deg;
    if (key.zoom) pose[kDistance] = first[kDistance] - std::log(*key.zoom);
    if (key.fov_deg) pose[kLens] = *key.fov_deg;
    if (key.eye) look_from(pose, *key.eye);
    if (!pose.allFinite())
      throw Error(where + ": camera.keys[" + std::to_string(k) + "]", "eye and target are the same point",
                  "expected two different points");
    times_.push_back(key.time);
    poses_.push_back(pose);
  }
  const std::size_t count = poses_.size();
  slopes_.assign(count, Pose::Zero());
  const auto slope = [&](std::size_t k) { return Pose((poses_[k + 1] - poses_[k]) / (times_[k + 1] - times_[k])); };
  for (std::size_t k = 0; k < count && count > 1; ++k) {
    if (k == 0 || k + 1 == count) {
      slopes_[k] = slope(k == 0 ? 0 : k - 1);
      continue;
    }
    const Pose before = slope(k - 1), after = slope(k);
    for (int i = 0; i < Pose::RowsAtCompileTime; ++i)
      slopes_[k][i] = monotone_slope(before[i], after[i], times_[k] - times_[k - 1], times_[k + 1] - times_[k]);
  }
}

CameraSettings CameraPath::at(double time) const {
  const auto next = std::upper_bound(times_.begin(), times_.end(), time);
  if (next == times_.begin()) return camera_of(poses_.front());
  if (next == times_.end()) return camera_of(poses_.back());
  const auto k = static_cast<std::size_t>(next - times_.begin()) - 1;
  const double length = times_[k + 1] - times_[k], t = (time - times_[k]) / length;
  if (!smooth_) return camera_of((1 - t) * poses_[k] + t * poses_[k + 1]);
  const double t2 = t * t, t3 = t2 * t;
  return camera_of((2 * t3 - 3 * t2 + 1) * poses_[k] + (t3 - 2 * t2 + t) * length * slopes_[k] +
                   (3 * t2 - 2 * t3) * poses_[k + 1] + (t3 - t2) * length * slopes_[k + 1]);
}

CameraSettings CameraPath::camera_of(const Pose& pose) const {
  const double azimuth = pose[kAzimuth] * kRadians, elevation = pose[kElevation] * kRadians;
  const Vector3d view = standing_axes(up_) * Vector3d(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                                                      std::cos(elevation) * std::cos(azimuth));
  const Vector3d target = pose.segment<3>(kTarget);
  return {target + std::exp(pose[kDistance]) * view, target, up_, pose[kLens]};
}

CameraSettings turned(const CameraSettings& camera, double degrees) {
  CameraSettings result = camera;
  result.eye =
      camera.target + Eigen::AngleAxisd(degrees * kRadians, camera.up.normalized()) * (camera.eye - camera.target);
  return result;
}

}  // namespace fascia
