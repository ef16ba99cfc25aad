// Line charts as files; the content of a chart is independent of gnuplot.
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
  std::optional<Eigen::Vector2d> range;  // absent: the range of the data, from 0 if linear
};

struct Series {
  std::string name;                     // in the legend; empty: none
  std::vector<Eigen::Vector2d> points;  // values that are not finite, or not positive on a logarithmic axis, are gaps
  int color = 0;                        // index into a palette that color-blind people can distinguish, from 0
  int dash = 0;                         // 0: solid
  bool line = true, marks = false;
};

struct Level {  // a horizontal line across the chart, labeled at the left
  std::string name;
  double y = 0;
};

struct Chart {
  std::string title;
  Axis x, y;
  std::vector<Series> series;
  std::vector<Level> levels;
};

/// Draws `path`.svg and `path`.png; the legend is below, in three columns. Throws Error, also if gnuplot is not
/// installed.
void write_chart(const std::filesystem::path& path, const Chart& chart);

/// A text as a gnuplot string.
std::string gnuplot_quoted(const std::string& text);

}  // namespace fascia
