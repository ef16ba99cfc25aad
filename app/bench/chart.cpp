#include "app/bench/chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "app/bench/gnuplot.h"

namespace fascia {
namespace {

// Okabe and Ito's colors without yellow, which is lost on white; the last one is for lines beside a palette of six.
constexpr std::array kColors{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};
constexpr std::array kDashes{"solid", "(14,5)", "(3,4)", "(14,4,3,4)"};
constexpr std::array kMarks{7, 5, 9, 11, 13, 15};  // filled shapes; one less is the same shape, empty

template <class Table>
auto turn(const Table& table, int index) {
  return table[static_cast<std::size_t>(index) % table.size()];
}

bool visible(double value, const Axis& axis) { return std::isfinite(value) && (!axis.logarithmic || value > 0); }

void write_axis(std::ostream& out, char name, const Axis& axis) {
  out << "set " << name << "label " << gnuplot_quoted(axis.label) << '\n';
  out << "set format " << name << " '%g'\n";
  if (axis.logarithmic) out << "set logscale " << name << "\nset m" << name << "tics 10\n";
  if (!axis.logarithmic && !axis.range) out << "set " << name << "range [0:*]\n";
  if (axis.range) out << "set " << name << "range [" << axis.range->x() << ':' << axis.range->y() << "]\n";
}

void write_points(std::ostream& out, std::size_t index, const Series& series, const Chart& chart) {
  out << "$data" << index << " << END\n";
  for (const Eigen::Vector2d& p : series.points) {
    if (visible(p.x(), chart.x) && visible(p.y(), chart.y)) out << p.x() << ' ' << p.y();
    out << '\n';  // an empty line is a gap
  }
  out << "END\n";
}

std::string title_in_legend(const std::string& name) {
  return name.empty() ? "notitle" : "title " + gnuplot_quoted(name);
}

void write_series(std::ostream& out, std::size_t index, const Series& series, const Chart& chart) {
  bool any = false;
  for (const Eigen::Vector2d& p : series.points) any = any || (visible(p.x(), chart.x) && visible(p.y(), chart.y));
  out << (any ? "$data" + std::to_string(index) + " using 1:2" : "NaN");  // NaN: the name in the legend and no line
  out << " with " << (series.line && series.marks ? "linespoints" : series.line ? "lines" : "points");
  out << " linecolor rgb '" << turn(kColors, series.color) << '\'';
  if (series.line) out << " dashtype " << turn(kDashes, series.dash) << " linewidth 2";
  if (series.marks) out << " pointtype " << turn(kMarks, series.color) + (series.line ? 0 : -1) << " pointsize 1.3";
  out << ' ' << title_in_legend(series.name);
}

struct Legend {
  std::size_t rows;
  double correction;  // of gnuplot's estimate of a column's width [characters], which is too wide for small letters
};

// In as many columns as the longest name leaves room for, three at most.
Legend legend_of(const Chart& chart) {
  constexpr double kSample = 0.06, kCharacter = 0.0078;  // of the chart's width
  std::size_t names = 0, longest = 0;
  for (const Series& series : chart.series) {
    names += !series.name.empty();
    longest = std::max(longest, series.name.size());
  }
  const auto columns =
      static_cast<std::size_t>(std::clamp(1 / (kSample + kCharacter * static_cast<double>(longest)), 1.0, 3.0));
  return {std::max<std::size_t>(1, (names + columns - 1) / columns), -0.15 * static_cast<double>(longest)};
}

std::string script_of(const Chart& chart, const std::string& terminal) {
  std::ostringstream out;
  out.precision(7);
  out << "set encoding utf8\nset terminal " << terminal << '\n';
  out << "set title " << gnuplot_quoted(chart.title) << '\n';
  // Below the data and the title of their axis, so that the legend covers neither.
  const Legend legend = legend_of(chart);
  out << "set bmargin " << 4.6 + 0.9 * static_cast<double>(legend.rows) << '\n'
      << "set key at screen 0.5, screen 0.015 center bottom vertical maxrows " << legend.rows
      << " Left reverse samplen 2.5 width " << legend.correction << " font ',13'\n";
  out << "set border 3 linecolor rgb '#404040'\nset tics nomirror out\nset grid linetype 1 linecolor rgb '#e0e0e0'\n";
  write_axis(out, 'x', chart.x);
  write_axis(out, 'y', chart.y);
  for (std::size_t i = 0; i < chart.series.size(); ++i) write_points(out, i, chart.series[i], chart);
  for (const Level& level : chart.levels)
    out << "set label " << gnuplot_quoted(level.name) << " at graph 0.01, first " << level.y
        << " left offset 0,0.6 front\n";
  const char* separator = "plot ";
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    out << separator;
    write_series(out, i, chart.series[i], chart);
    separator = ", ";
  }
  for (const Level& level : chart.levels) {
    out << separator << level.y << " with lines linecolor rgb 'black' linewidth 2 notitle";
    separator = ", ";
  }
  out << '\n';
  return out.str();
}

}  // namespace

std::string gnuplot_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

void write_chart(const std::filesystem::path& path, const Chart& chart) {
  const auto named = [&](const char* ending) {
    std::filesystem::path name = path;
    return name += ending;
  };
  run_gnuplot(named(".svg"),
              script_of(chart, "svg size 960,640 dynamic noenhanced font 'DejaVu Sans,15' background '#ffffff'"));
  run_gnuplot(named(".png"), script_of(chart, "pngcairo size 1440,960 noenhanced font 'DejaVu Sans,17' linewidth 1.5"));
}

}  // namespace fascia
