#include "render/view/color_map.h"

#include <algorithm>

namespace fascia {

Eigen::Vector3f ColorMapCurve::operator()(float t) const {
  t = std::clamp(t, 0.0f, 1.0f);
  Eigen::Vector3f color = Eigen::Vector3f::Zero();
  for (std::size_t k = coefficients.size(); k-- > 0;)
    color = color * t + Eigen::Vector3f(coefficients[k][0], coefficients[k][1], coefficients[k][2]);
  return color;
}

namespace color_maps {

const ColorMapCurve dusk{{{{0.1941f, 0.0546f, 0.4469f},
                           {0.0435f, 1.6120f, 0.9536f},
                           {-9.5676f, -2.7173f, -4.9611f},
                           {46.3621f, 4.9944f, 13.8098f},
                           {-89.3260f, -2.9572f, -14.8614f},
                           {81.6521f, -1.4323f, 1.4386f},
                           {-28.4079f, 1.3701f, 3.7153f}}}};
const ColorMapCurve ember{{{{0.1722f, 0.0043f, 0.1328f},
                            {1.0512f, 0.3859f, 0.1172f},
                            {-0.1205f, 0.6904f, 5.1725f},
                            {5.8795f, -3.4187f, -29.6474f},
                            {-18.6514f, 12.0742f, 59.4448f},
                            {19.4606f, -14.2796f, -49.4973f},
                            {-6.8104f, 5.4917f, 14.9401f}}}};
const ColorMapCurve polar{{{{0.0759f, 0.3553f, 0.6863f},
                            {3.0865f, 2.2162f, 1.4148f},
                            {-14.4041f, -12.9247f, -8.8281f},
                            {64.4992f, 66.7282f, 46.0406f},
                            {-130.7903f, -148.1021f, -107.0755f},
                            {115.2057f, 138.3938f, 103.5421f},
                            {-37.0460f, -46.4707f, -35.6935f}}}};
const ColorMapCurve grey{{{{0.1040f, 0.1040f, 0.1040f},
                           {0.6777f, 0.6777f, 0.6777f},
                           {0.2821f, 0.2821f, 0.2821f},
                           {-0.1959f, -0.1959f, -0.1959f},
                           {0.1565f, 0.1565f, 0.1565f},
                           {-0.0840f, -0.0840f, -0.0840f},
                           {0.0203f, 0.0203f, 0.0203f}}}};

}  // namespace color_maps

Eigen::Vector3f region_color(unsigned n) {
  static const std::array<std::uint32_t, kRegionColors> colors{0xE69F00, 0x56B4E9, 0x009E73, 0xCC79A7,
                                                               0xF0E442, 0x0072B2, 0xD55E00, 0xA0A0A0};
  const std::uint32_t c = colors[n % kRegionColors];
  return Eigen::Vector3f(static_cast<float>(c >> 16), static_cast<float>(c >> 8 & 255), static_cast<float>(c & 255)) /
         255;
}

}  // namespace fascia
