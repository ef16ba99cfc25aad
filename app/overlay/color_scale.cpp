#include "app/overlay/color_scale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/ui/ticks.h"
#include "app/ui/units.h"

namespace fascia {
namespace {

// A number without a unit gets as many decimals as the step between ticks.
std::string tick_text(double value, double step, int digits, const std::string& unit) {
  if (std::abs(value) < 1e-9 * step) value = 0;
  const double size = std::max(std::abs(value), step);
  if (!unit.empty() || size < 1e-4 || size >= 1e5) return engineering(value, unit, std::max(digits, 3));
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 8),
                value);
  return text;
}

Ticks ticks_of(const Eigen::Vector2d& range) {
  constexpr int kUsual = 5;  // intervals
  for (const int most : {kUsual, 4, 3, 2, 6, 7, 8, 9, 10}) {
    const Ticks ticks = linear_ticks(range.x(), range.y(), most);
    const double rounding = 1e-6 * range.cwiseAbs().maxCoeff();
    if (std::abs(ticks.values.front() - range.x()) <= rounding && std::abs(ticks.values.back() - range.y()) <= rounding)
      return ticks;
  }
  return linear_ticks(range.x(), range.y(), kUsual);
}

}  // namespace

ColorScale color_scale(const Look& look, const Quantity& quantity, const std::array<bool, 2>& beyond) {
  const Eigen::Vector2d range = look.range.cast<double>();
  const Ticks ticks = ticks_of(range);
  const double step = ticks.values.size() > 1 ? ticks.values[1] - ticks.values[0] : 1;
  ColorScale scale{quantity.title, {}, beyond};
  for (const double value : ticks.values)
    scale.ticks.push_back(
        {(value - range.x()) / (range.y() - range.x()), tick_text(value, step, ticks.digits, quantity.unit)});
  return scale;
}

Eigen::Vector3f color_at(const Look& look, float share) {
  const Eigen::Vector2f ends = map_range(look);
  const float value = look.range.x() + share * (look.range.y() - look.range.x());
  return (*look.color_map)(ends.y() > ends.x() ? (value - ends.x()) / (ends.y() - ends.x()) : 0);
}

}  // namespace fascia
