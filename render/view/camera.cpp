#include "render/view/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kMargin = 0.88;             // share of the picture that fit() gives the box
constexpr double kSteepest = 89 * kRadians;  // elevation at which orbit() stops
constexpr double kNearShare = 0.02;          // near plane as a share of the distance to the target
constexpr double kFarRadii = 20;             // far plane behind the target, in scene radii: includes the faded ground

/// The horizontal axis that points right in a front view: +x for y up and for z up.
Vector3d front_right(const Vector3d& up) {
  const Vector3d seed = std::abs(up.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitY();
  return (seed - up * up.dot(seed)).normalized();
}

}  // namespace

Eigen::Matrix3d standing_axes(const Vector3d& up) {
  const Vector3d unit = up.normalized(), right = front_right(unit);
  Eigen::Matrix3d axes;
  axes << right, unit, right.cross(unit);
  return axes;
}

Vector3d Camera::forward() const {
  const double length = distance();
  if (length > 0) return (target - eye) / length;
  return -standing_axes(up).col(2);
}

double Camera::slope() const { return reach * std::tan(fov_deg * kRadians / 2); }

Eigen::Vector2d Camera::slopes(double aspect) const {
  return slope() * Eigen::Vector2d(std::max(aspect, 1.0), std::max(1 / aspect, 1.0));
}

Eigen::Matrix3d Camera::axes() const {
  const Vector3d direction = forward();
  Vector3d right = direction.cross(up.normalized());
  right = right.norm() > 1e-9 ? Vector3d(right.normalized()) : front_right(direction);
  Eigen::Matrix3d result;
  result << right, right.cross(direction), -direction;
  return result;
}

void Camera::look_as(const Camera& other) {
  eye = other.eye;
  target = other.target;
  up = other.up;
  fov_deg = other.fov_deg;
}

void Camera::frame(const Vector3d& box_min, const Vector3d& box_max) {
  constexpr double kAzimuth = 28 * kRadians, kElevation = 20 * kRadians;
  const Vector3d unit_up = up.normalized(), right = front_right(unit_up), front = right.cross(unit_up);
  const Vector3d direction =
      std::cos(kElevation) * (std::cos(kAzimuth) * front + std::sin(kAzimuth) * right) + std::sin(kElevation) * unit_up;
  const double size = (box_max - box_min).norm();
  target = (box_min + box_max) / 2;
  eye = target + direction * (size > 0 ? size : 1.0);
  fit(box_min, box_max, 1.0);
}

void Camera::fit(const Vector3d& box_min, const Vector3d& box_max, double aspect, const Eigen::Vector2d& part) {
  const Vector3d center = (box_min + box_max) / 2;
  const Eigen::Matrix3d basis = axes();
  const Eigen::Vector2d slope = kMargin * slopes(aspect).cwiseProduct(part);
  // In camera axes, with depth f along the line of sight, an eye at (r, u, f) sees a corner (r_i, u_i, f_i) if
  // |r_i - r| <= slope (f_i - f), and the same for u. Per axis the tightest corner on either side bounds f.
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Eigen::Vector2d low(-kInfinity, -kInfinity), high(kInfinity, kInfinity);
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d point(corner & 1 ? box_max.x() : box_min.x(), corner & 2 ? box_max.y() : box_min.y(),
                         corner & 4 ? box_max.z() : box_min.z());
    const Vector3d p = basis.transpose() * (point - center);
    const double depth = -p.z();
    low = low.cwiseMax(p.head<2>() - slope * depth);
    high = high.cwiseMin(p.head<2>() + slope * depth);
  }
  const double f = (high - low).cwiseQuotient(2 * slope).minCoeff();
  // For a box without size the eye keeps its distance.
  const double back = (box_max - box_min).norm() > 0 ? -f : std::max(distance(), 1e-6);
  eye = center + basis * Vector3d((low.x() + high.x()) / 2, (low.y() + high.y()) / 2, back);
  target = eye - basis.col(2) * back;
}

void Camera::orbit(double dx, double dy) {
  const Vector3d unit_up = up.normalized(), offset = eye - target;
  const double length = offset.norm();
  if (length == 0) return;
  const double elevation = std::asin(std::clamp(offset.dot(unit_up) / length, -1.0, 1.0));
  Vector3d horizontal = offset - unit_up * offset.dot(unit_up);
  horizontal = horizontal.norm() > 1e-9 * length ? Vector3d(horizontal.normalized()) : axes().col(0).cross(unit_up);
  horizontal = Eigen::AngleAxisd(-dx, unit_up) * horizontal;
  const double steepness = std::clamp(elevation + dy, -kSteepest, kSteepest);
  eye = target + length * (std::cos(steepness) * horizontal + std::sin(steepness) * unit_up);
}

void Camera::pan(double dx, double dy) {
  const Eigen::Matrix3d basis = axes();
  const Vector3d shift = 2 * slope() * distance() * (-dx * basis.col(0) + dy * basis.col(1));
  eye += shift;
  target += shift;
}

void Camera::zoom(double factor) { eye = target + (eye - target) * factor; }

Eigen::Matrix4f Camera::view() const {
  const Eigen::Matrix3d rotation = axes().transpose();
  Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
  result.topLeftCorner<3, 3>() = rotation;
  result.topRightCorner<3, 1>() = -rotation * eye;
  return result.cast<float>();
}

Eigen::Matrix4f Camera::projection(double aspect, double scene_radius) const {
  // The ground reaches up to the eye, so the near plane stays close; a ratio below 1e4 suits 24 bits of depth, also
  // when zoomed in to a hundredth of the scene.
  const double near = kNearShare * std::max(distance(), 0.01 * scene_radius);
  const double far = distance() + kFarRadii * scene_radius;
  Eigen::Matrix4d result = Eigen::Matrix4d::Zero();
  result.diagonal().head<2>() = slopes(aspect).cwiseInverse();
  result(2, 2) = -(far + near) / (far - near);
  result(2, 3) = -2 * far * near / (far - near);
  result(3, 2) = -1;
  result.block<2, 1>(0, 2) = -(middle + jitter);
  return result.cast<float>();
}

Ray Camera::ray(double x, double y, int width, int height) const {
  const double per_pixel = 2 * slope() / std::min(width, height);
  const Vector3d in_view((x - (1 + middle.x()) * width / 2) * per_pixel,
                         ((1 - middle.y()) * height / 2 - y) * per_pixel, -1);
  return {eye, (axes() * in_view).normalized()};
}

Eigen::Vector2d Camera::extent(std::span<const Vector3d> points) const {
  const Eigen::Matrix3d basis = axes();
  const double unit = slope() / reach;
  Eigen::AlignedBox1d seen;
  for (const Vector3d& point : points) {
    const double right = basis.col(0).dot(point - eye), depth = -basis.col(2).dot(point - eye);
    if (depth > 0) seen.extend(Eigen::Matrix<double, 1, 1>(right / (depth * unit)));
  }
  return seen.isEmpty() ? Eigen::Vector2d(-1, 1) : Eigen::Vector2d(seen.min()(0), seen.max()(0));
}

double Camera::pixel_size(const Vector3d& point, int width, int height) const {
  return 2 * slope() * std::abs((point - eye).dot(forward())) / std::min(width, height);
}

}  // namespace fascia
