#include "app/charts/chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "app/charts/gnuplot.h"
#include "base/error.h"
#include "base/file.h"

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

// Ticks of a logarithmic axis that spans less than two decades, on which powers of ten are too few to read values from:
// 1, 2 and 5 of each decade with numbers, the others without and smaller.
std::string ticks_between(double least, double most) {
  std::ostringstream ticks;
  for (int decade = static_cast<int>(std::floor(std::log10(least))); std::pow(10, decade) <= most; ++decade)
    for (int digit = 1; digit < 10; ++digit) {
      const double tick = digit * std::pow(10, decade);
      if (tick < least || tick > most) continue;
      const bool with_number = digit == 1 || digit == 2 || digit == 5;
      ticks << (ticks.tellp() > 0 ? ", " : "") << (with_number ? "" : "'' ") << tick << (with_number ? "" : " 1");
    }
  return ticks.str();
}

// Smallest and largest value that is drawn along an axis, with a margin on logarithmic axes, on which gnuplot would
// extend the range to whole decades. None: gnuplot finds it.
std::optional<Eigen::Vector2d> range_of(const Axis& axis, const Chart& chart, int dimension) {
  if (axis.range || !axis.logarithmic) return axis.range;
  constexpr double kMargin = 1.25;
  double least = HUGE_VAL, most = 0;
  for (const Series& series : chart.series)
    for (const Eigen::Vector2d& p : series.points)
      if (visible(p.x(), chart.x) && visible(p.y(), chart.y)) {
        least = std::min(least, p[dimension]);
        most = std::max(most, p[dimension]);
      }
  if (!(most > 0)) return std::nullopt;
  return Eigen::Vector2d(least / kMargin, most * kMargin);
}

void write_axis(std::ostream& out, int dimension, const Axis& axis, const Chart& chart) {
  const char name = dimension == 0 ? 'x' : 'y';
  const std::optional<Eigen::Vector2d> range = range_of(axis, chart, dimension);
  // One notation for all ticks: %g would change from 0.0001 to 1e-05 within an axis.
  const bool powers = axis.logarithmic && range && (range->x() < 1e-4 || range->y() > 1e5);
  out << "set " << name << "label " << gnuplot_quoted(axis.label) << " noenhanced\n";
  out << "set format " << name << (powers ? " '10^{%L}'\n" : " '%g'\n");
  if (axis.logarithmic) out << "set logscale " << name << "\nset m" << name << "tics 10\n";
  if (axis.logarithmic && range && !powers && range->y() < 100 * range->x())
    out << "set " << name << "tics (" << ticks_between(range->x(), range->y()) << ")\n";
  if (range)
    out << "set " << name << "range [" << range->x() << ':' << range->y() << "]\n";
  else if (!axis.logarithmic)
    out << "set " << name << "range [0:*]\n";
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

void write_series(std::ostream& out, std::size_t index, const Series& series, const Chart& chart, double mark) {
  bool any = false;
  for (const Eigen::Vector2d& p : series.points) any = any || (visible(p.x(), chart.x) && visible(p.y(), chart.y));
  out << (any ? "$data" + std::to_string(index) + " using 1:2" : "NaN");  // NaN: the name in the legend and no line
  out << " with " << (series.line && series.marks ? "linespoints" : series.line ? "lines" : "points");
  out << " linecolor rgb '" << turn(kColors, series.color) << '\'';
  if (series.line) out << " dashtype " << turn(kDashes, series.dash) << " linewidth 2";
  if (series.marks)
    out << " pointtype " << turn(kMarks, series.color) + (series.line ? 0 : -1) << " pointsize " << mark;
  out << ' ' << title_in_legend(series.name);
}

// How a format is drawn: gnuplot's terminals measure marks and texts differently.
struct Format {
  const char *ending, *terminal;
  int legend_font;  // [points of the terminal]
  double mark;      // size of a mark
  double too_wide;  // share by which a column of the legend is estimated too wide, whose letters are small
};
constexpr std::array kFormats{
    Format{".svg", "svg size 960,640 dynamic enhanced font 'DejaVu Sans,15' background '#ffffff'", 13, 0.65, 0.24},
    Format{".png", "pngcairo size 1440,960 enhanced font 'DejaVu Sans,17' linewidth 1.5", 13, 1.3, 0.15},
    Format{".pdf", "pdfcairo size 20cm,13.33cm enhanced font 'DejaVu Sans,11' linewidth 1.2", 8, 0.6, 0.15}};

// Rows of the legend, in as many columns as the longest name leaves room for, three at most.
struct Columns {
  std::size_t rows;
  double longest;  // [characters]
};

Columns columns_of(const Chart& chart) {
  constexpr double kSample = 0.06, kCharacter = 0.0078;  // of the chart's width
  std::size_t names = 0, longest = 0;
  for (const Series& series : chart.series) {
    names += !series.name.empty();
    longest = std::max(longest, series.name.size());
  }
  const auto columns =
      static_cast<std::size_t>(std::clamp(1 / (kSample + kCharacter * static_cast<double>(longest)), 1.0, 3.0));
  return {std::max<std::size_t>(1, (names + columns - 1) / columns), static_cast<double>(longest)};
}

std::string script_of(const Chart& chart, const Format& format) {
  std::ostringstream out;
  out.precision(7);
  out << "set encoding utf8\nset terminal " << format.terminal << '\n';
  out << "set title " << gnuplot_quoted(chart.title) << " noenhanced\n";
  // Below the data and the title of their axis, so that the legend covers neither.
  const Columns legend = columns_of(chart);
  out << "set bmargin " << 4.6 + 0.9 * static_cast<double>(legend.rows) << '\n'
      << "set key at screen 0.5, screen 0.015 center bottom vertical maxrows " << legend.rows
      << " Left reverse samplen 2.5 width " << -format.too_wide * legend.longest << " font '," << format.legend_font
      << "' noenhanced\n";
  out << "set border 3 linecolor rgb '#404040'\nset tics nomirror out\nset grid linetype 1 linecolor rgb '#e0e0e0'\n";
  write_axis(out, 0, chart.x, chart);
  write_axis(out, 1, chart.y, chart);
  for (std::size_t i = 0; i < chart.series.size(); ++i) write_points(out, i, chart.series[i], chart);
  for (const Level& level : chart.levels)
    out << "set label " << gnuplot_quoted(level.name) << " at graph 0.01, first " << level.y
        << " left offset 0,0.6 front noenhanced\n";
  const char* separator = "plot ";
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    out << separator;
    write_series(out, i, chart.series[i], chart, format.mark);
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

std::string gnuplot_color(const Eigen::Vector3f& color) {
  char text[8];
  const auto byte = [&](int k) { return static_cast<unsigned>(255 * std::clamp(color[k], 0.0f, 1.0f) + 0.5f); };
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(0), byte(1), byte(2));
  return text;
}

std::vector<std::string> chart_endings() {
  std::vector<std::string> endings;
  for (const Format& format : kFormats) endings.emplace_back(format.ending);
  return endings;
}

void write_chart(const std::filesystem::path& path, const Chart& chart) {
  const std::string ending = lower_ending(path);
  const auto format =
      std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& f) { return f.ending == ending; });
  if (format == kFormats.end()) throw Error(path.string(), "is not a chart format", "expected .svg, .png or .pdf");
  run_gnuplot(path, script_of(chart, *format), chart.title);
}

}  // namespace fascia
