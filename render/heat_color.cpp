#include <algorithm>

#include "render/look.h"

namespace fascia {

Eigen::Vector3f heat_color(float t) {
  // Fitted to a path of equal steps in OKLab (lightness 0.30 to 0.93, hue 290 to 103 degrees); the same
  // numbers as shaders/common/heat.glsl.
  static const float coefficients[7][3] = {{0.1941f, 0.0546f, 0.4469f},      {0.0435f, 1.6120f, 0.9536f},
                                           {-9.5676f, -2.7173f, -4.9611f},   {46.3621f, 4.9944f, 13.8098f},
                                           {-89.3260f, -2.9572f, -14.8614f}, {81.6521f, -1.4323f, 1.4386f},
                                           {-28.4079f, 1.3701f, 3.7153f}};
  t = std::clamp(t, 0.0f, 1.0f);
  Eigen::Vector3f color = Eigen::Vector3f::Zero();
  for (int k = 6; k >= 0; --k)
    color = color * t + Eigen::Vector3f(coefficients[k][0], coefficients[k][1], coefficients[k][2]);
  return color;
}

}  // namespace fascia
