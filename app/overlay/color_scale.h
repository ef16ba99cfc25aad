// The content of a color bar, apart from how it is drawn: over the picture (color_bar.h) or as a file (legend_file.h).
#pragma once
#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "render/view/look.h"
#include "sim/scene/settings/display.h"

namespace fascia {

struct ColorScale {
  struct Tick {
    double share;  // of the bar, from its lower end
    std::string text;
  };
  std::string title;
  std::vector<Tick> ticks;
  std::array<bool, 2> beyond{};  // values lie below the lower and above the upper end
};

/// Ticks at round numbers, one at both ends if round steps connect them.
ColorScale color_scale(const Look& look, const Quantity& quantity, const std::array<bool, 2>& beyond);

/// sRGB at a share of the bar, from its lower end.
Eigen::Vector3f color_at(const Look& look, float share);

}  // namespace fascia
