// A small chart inside a panel: values over iterations on a logarithmic scale, with decades marked.
#pragma once
#include <string>
#include <vector>

#include <imgui.h>

namespace fascia::ui {

struct Curve {
  ImU32 color;
  const std::vector<float>* values;  // at 0, 1, 2, ...; those not above 0 are left out
};

/// As wide as the panel, `height` points high. A tooltip shows the values at the mouse.
void log_plot(const char* id, const std::vector<Curve>& curves, float height);

/// Colors that are easy to distinguish, also for the color-blind (Okabe and Ito 2008).
ImU32 curve_color(std::size_t index);

}  // namespace fascia::ui
