// Line charts as files: what is drawn, apart from how gnuplot is told to.
#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fascia {

struct Axis {
  std::string label;  // with its unit
  bool logarithmic = false;
  std::optional<Eigen::Vector2d> range;  // smallest and largest value; absent: that of the data, from 0 if linear
};

struct Series {
  std::string name;                     // in the legend; empty: none
  std::vector<Eigen::Vector2d> points;  // what is not finite, or not positive on a logarithmic axis, is a gap
  int color = 0;                        // number of a palette that color-blind people can tell apart, from 0
  int dash = 0;                         // 0: solid
  bool line = true, marks = false;
};

struct Level {  // a horizontal line through the whole chart, with its name on it at the left
  std::string name;
  double y = 0;
};

struct Chart {
  std::string title;
  Axis x, y;
  std::vector<Series> series;
  std::vector<Level> levels;
};

/// Draws the chart as SVG, PNG or PDF, by the ending of `path`; the legend stands below, in up to three columns. Throws
/// Error, also when gnuplot is not installed.
void write_chart(const std::filesystem::path& path, const Chart& chart);
std::vector<std::string> chart_endings();  // ".svg", ...

/// A text as a gnuplot string.
std::string gnuplot_quoted(const std::string& text);
/// An sRGB color as gnuplot reads it, "#0072b2".
std::string gnuplot_color(const Eigen::Vector3f& color);

}  // namespace fascia
