// Color maps: curves through the display's colors on which equal steps of the number look equally large. Each is a
// polynomial of degree six per channel, sRGB over 0 to 1, fitted to a path of equal steps in OKLab (Ottosson 2020);
// shaders and the color bar evaluate the same numbers.
#pragma once
#include <Eigen/Core>
#include <array>

namespace fascia {

struct ColorMapCurve {
  std::array<std::array<float, 3>, 7> coefficients;  // of t^0 to t^6
  Eigen::Vector3f operator()(float t) const;         // sRGB; t is clamped to 0 to 1
};

namespace color_maps {
extern const ColorMapCurve dusk;   // sequential: violet over green to pale yellow, lightness 0.30 to 0.93
extern const ColorMapCurve ember;  // sequential: nearly black over red to pale yellow, lightness 0.20 to 0.95
extern const ColorMapCurve
    polar;  // diverging: blue over almost white to red, equally light on both sides, 0.48 and 0.94
extern const ColorMapCurve grey;  // sequential gray, for print: lightness 0.22 to 0.97
}  // namespace color_maps

/// sRGB of the n-th region: Okabe and Ito's colors (2008), which color-blind people can distinguish; from the ninth on
/// they repeat.
constexpr int kRegionColors = 8;
Eigen::Vector3f region_color(unsigned n);

}  // namespace fascia
