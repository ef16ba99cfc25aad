// The state of the panel Plots: samples over time, the charts, and the shown interval. While it is off, no samples are
// kept.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/fit/estimate.h"
#include "sim/output/sample_history.h"

namespace fascia {

/// A fit of values of the scene to the measured samples.
struct FitPanel {
  std::vector<std::string> keys;  // chosen free values, as for --free
  bool equilibria = false;        // every time is a static equilibrium
  bool running = false;
  std::string line;  // how far it is, or why it failed; empty: nothing to say
  bool failed = false;
  std::vector<Estimate> found;  // values that can be applied
};

struct Plots {
  static constexpr std::size_t kCharts = 10;

  bool shown = false, held = false;  // held: samples are not added, so that the chart can be read
  std::array<bool, kCharts> chosen{true, true, true, true, true, false, false, false, false, false};
  SampleHistory history;
  std::vector<Sample> measured;  // of a file, ascending in time: drawn dashed beside the history
  std::filesystem::path measured_file;
  FitPanel fit;               // of the measured samples
  double span = 10;           // seconds shown
  std::optional<double> end;  // right edge [s]; none: the latest sample
  std::optional<double> cursor,
      cursor_next;  // time under the mouse [s], in the previous frame and in this one: all charts show the same
  std::optional<std::uint32_t> probe;              // tracked vertex; none: the tip, once there are plots
  bool choosing = false;                           // the next click on the tissue selects the probe
  float left = 0, top = 0, width = 0, height = 0;  // of the panel in the picture [pixels]
  float charts_top = 0;                            // of its part below the buttons [pixels]
  bool docked = true;  // until it is moved or resized, it fills the right or lower side of the picture, at any size
  std::array<float, 4> dock{};  // its area in the previous frame: left, top, width, height [pixels]
  bool at_bottom = false;       // the dock is below the tissue, since a narrow picture has no room beside it

  double right_edge() const { return end ? *end : history.all().empty() ? span : history.all().back().time; }
  /// The measured samples between two times [s], and one more at each side.
  std::span<const Sample> measured_between(double from, double to) const { return part(measured, from, to); }
  /// Discards samples and measurement.
  void clear();
  /// Call when the scene changes: discards samples, measurement and probe.
  void forget();
};

}  // namespace fascia
