// What a picture of the scene shows and how, apart from the camera.
#pragma once
#include <Eigen/Core>

namespace fascia {

struct Look {
  bool wireframe = false;
  bool heat_map = false;  // color by position.w over `range`, else by `color`
  Eigen::Vector2f range{0, 1};
  Eigen::Vector3f color{0.80f, 0.34f, 0.29f};  // tissue, sRGB
  bool shadow = true, ground = true;
  double ground_height = 0;         // of the ground plane along `up` [m]
  Eigen::Vector3d center{0, 0, 0};  // of the scene at rest [m]
  double radius = 1;                // of the scene at rest [m]: sets light, shadow and grid scale
  Eigen::Vector3d up{0, 1, 0};
};

/// A stretched spring from the grabbed patch to the mouse.
struct GrabMark {
  Eigen::Vector3f from, to;
};

/// Color of the heat map at t in [0, 1], sRGB (violet to yellow, lightness rising evenly): for the color bar.
/// The shader uses the same, and a surface in full light shows it unchanged.
Eigen::Vector3f heat_color(float t);

}  // namespace fascia
