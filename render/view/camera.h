// The view: the place of the camera, its motion with the mouse, and the ray under a pixel. Independent of OpenGL.
// Mouse amounts are positive to the right and down, as pixels are; the scene follows the mouse.
#pragma once
#include <Eigen/Core>
#include <span>

#include "base/ray.h"

namespace fascia {

/// Columns: right, up, front of a scene that stands along `up`; x, y, z for y up, and a front view along +y for z up.
Eigen::Matrix3d standing_axes(const Eigen::Vector3d& up);

class Camera {
 public:
  Eigen::Vector3d eye{0, 0.3, 1}, target{0, 0, 0}, up{0, 1, 0};
  double fov_deg = 40;  // across the shorter side of the picture, so that a narrow one still shows the whole body
  Eigen::Vector2d middle{
      0, 0};  // position of the target in the picture: from its center to the right and up, in halves of its size
  double reach = 1;              // the picture spans `reach` times fov_deg: above 1 the scene appears smaller
  Eigen::Vector2d jitter{0, 0};  // of the picture, right and up, in halves of its width and height (Supersampler)

  /// Takes position, direction and lens of `other`, for a different picture.
  void look_as(const Camera& other);
  /// Looks at the whole box from the front, slightly from the right and above, for any shape of the picture (down to a
  /// square).
  void frame(const Eigen::Vector3d& box_min, const Eigen::Vector3d& box_max);
  /// Keeps the direction of view and moves so that the box fills this part of the picture's width and height, around
  /// `middle`, with a margin. The target becomes the point on the line of sight at the depth of the box's center.
  void fit(const Eigen::Vector3d& box_min, const Eigen::Vector3d& box_max, double aspect,
           const Eigen::Vector2d& part = {1, 1});
  void orbit(double dx, double dy);  // radians about up and the right axis; stops before the pole
  void pan(double dx, double dy);    // shares of the picture's shorter side at the target's depth
  void zoom(double factor);          // distance to the target times factor

  /// Near and far planes are chosen to include a box of this radius around the target, and the ground.
  Eigen::Matrix4f view() const;
  Eigen::Matrix4f projection(double aspect, double scene_radius) const;
  /// x, y in pixels from the top left corner of a width x height picture; (0.5, 0.5) is the first pixel's center.
  Ray ray(double x, double y, int width, int height) const;
  /// The range of the points in front of the camera along a picture's width, in halves of the shorter side that fov_deg
  /// spans, 0 on the line of sight. (-1, 1) if there are none.
  Eigen::Vector2d extent(std::span<const Eigen::Vector3d> points) const;
  /// Meters per pixel at the depth of `point`.
  double pixel_size(const Eigen::Vector3d& point, int width, int height) const;
  Eigen::Vector3d forward() const;

 private:
  double distance() const { return (target - eye).norm(); }
  Eigen::Matrix3d axes() const;                 // columns: right, up, backward
  double slope() const;                         // tangent of half the angle across the shorter side
  Eigen::Vector2d slopes(double aspect) const;  // the same across width and height
};

}  // namespace fascia
