// What the panel Plots shows: samples over time, which charts, and which part of the time. Off, nothing is kept.
#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "sim/output/sample_history.h"

namespace fascia {

struct Plots {
  static constexpr std::size_t kCharts = 8;

  bool shown = false, held = false;  // held: nothing is added, to read what is there
  std::array<bool, kCharts> chosen{true, true, true, true, false, false, false, false};
  SampleHistory history;
  double span = 10;           // seconds shown
  std::optional<double> end;  // right edge [s]; none: the latest sample
  std::optional<double> cursor,
      cursor_next;  // time under the mouse [s], in the frame before and in this one: all charts show the same
  std::optional<std::uint32_t> probe;              // vertex that is followed; none: the tip, once there are plots
  bool choosing = false;                           // the next click on the tissue chooses the probe
  float left = 0, top = 0, width = 0, height = 0;  // of the panel in the picture [pixels]
  bool docked = true;  // until it is moved or resized, it fills the picture's right side, whatever size that gets
  std::array<float, 4> dock{};  // where that was in the frame before: left, top, width, height [pixels]

  double right_edge() const { return end ? *end : history.all().empty() ? span : history.all().back().time; }
  /// Another scene: its samples and its vertex are gone.
  void forget();
};

}  // namespace fascia
