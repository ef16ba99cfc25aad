// A chart over time inside a panel: curves of samples with axes, read at a cursor. All charts of a panel share the time
// and the cursor.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include <imgui.h>

#include "app/state/plots.h"

namespace fascia::ui {

struct TimeCurve {
  std::string name;
  std::function<double(const Sample&)> value;
};

struct TimeChart {
  const char* title;
  const char* unit;  // as in engineering(); "": a bare number
  bool logarithmic;
  std::vector<TimeCurve> curves;
};

/// A chart as wide as the panel and `height` points high. The line above it shows names and values at the cursor, or
/// the latest values. The wheel zooms in time, a drag scrolls, a double click follows the latest sample again. With
/// `times`, the axis of time is labeled.
void time_plot(const TimeChart& chart, Plots& plots, float height, bool times);

}  // namespace fascia::ui
