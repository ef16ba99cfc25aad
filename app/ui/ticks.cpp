#include "app/ui/ticks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fascia {

Ticks linear_ticks(double low, double high, int most) {
  Ticks ticks;
  if (!(high > low)) return {{low}, 3};
  const double rough = (high - low) / most, decade = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * decade;
  // Ranges may come from float32: an end that is a multiple of the step in decimal digits may differ from it by
  // rounding.
  const double largest = std::max(std::abs(low), std::abs(high)),
               rounding = std::numeric_limits<float>::epsilon() * largest;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * decade * most >= high - low - std::max(2 * rounding, 1e-6 * (high - low))) step = factor * decade;
  const auto take = [&](double spacing) {
    step = spacing;
    ticks.values.clear();
    const double slack = std::min(rounding / step + 1e-9, 0.25);  // [steps]
    for (double i = std::ceil(low / step - slack); i <= high / step + slack; ++i) ticks.values.push_back(i * step);
  };
  take(step);
  // One tick tells no scale. The next finer steps have two or three.
  for (const double factor : {5.0, 2.0, 1.0, 0.5, 0.2})
    if (ticks.values.size() < 2 && factor * decade < step) take(factor * decade);
  ticks.digits = std::clamp(static_cast<int>(std::floor(std::log10(largest)) - std::floor(std::log10(step))) + 1, 1, 9);
  return ticks;
}

Ticks decade_ticks(double low, double high, int most) {
  const int first = static_cast<int>(std::ceil(std::log10(low) - 1e-9)),
            last = static_cast<int>(std::floor(std::log10(high) + 1e-9));
  const int every = std::max(1, (last - first + most) / most);
  Ticks ticks{{}, 1};
  for (int decade = first; decade <= last; decade += every) ticks.values.push_back(std::pow(10.0, decade));
  return ticks;
}

}  // namespace fascia
