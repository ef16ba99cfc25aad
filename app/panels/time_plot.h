// A chart over time inside a panel: curves of samples with axes, read at a cursor. All charts of a panel share the time
// and the cursor.
#pragma once
#include <span>
#include <string>

#include <imgui.h>

#include "app/state/plots.h"

namespace fascia::ui {

struct TimeCurve {
  const char* name;
  double (*value)(const Sample&);
};

struct TimeChart {
  const char* title;
  const char* unit;  // as in engineering(); "": a bare number
  bool logarithmic;
  std::span<const TimeCurve> curves;
};

/// A chart as wide as the panel and `height` points high. The line above it shows names and values at the cursor, or
/// the latest values. The wheel zooms in time, a drag scrolls, a double click follows the latest sample again. With
/// `times`, the axis of time is labeled.
void time_plot(const TimeChart& chart, Plots& plots, float height, bool times);

}  // namespace fascia::ui
