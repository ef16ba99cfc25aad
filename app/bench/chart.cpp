#include "app/bench/chart.h"

#include <array>
#include <cmath>
#include <sstream>

#include "app/bench/gnuplot.h"

namespace fascia {
namespace {

// Okabe and Ito's colors without yellow, which is invisible on white; the last one is for lines beside a palette of
// six.
constexpr std::array kColors{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};
constexpr std::size_t kLegendColumns = 3;
constexpr std::array kDashes{"solid", "(14,5)", "(3,4)", "(14,4,3,4)"};
constexpr std::array kMarks{7, 5, 9, 11, 13, 15};  // filled shapes; the number below is the same shape, unfilled

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

std::string legend(const std::string& name) { return name.empty() ? "notitle" : "title " + gnuplot_quoted(name); }

void write_series(std::ostream& out, std::size_t index, const Series& series, const Chart& chart) {
  bool any = false;
  for (const Eigen::Vector2d& p : series.points) any = any || (visible(p.x(), chart.x) && visible(p.y(), chart.y));
  out << (any ? "$data" + std::to_string(index) + " using 1:2" : "NaN");  // NaN: an entry in the legend without a line
  out << " with " << (series.line && series.marks ? "linespoints" : series.line ? "lines" : "points");
  out << " linecolor rgb '" << turn(kColors, series.color) << '\'';
  if (series.line) out << " dashtype " << turn(kDashes, series.dash) << " linewidth 2";
  if (series.marks) out << " pointtype " << turn(kMarks, series.color) + (series.line ? 0 : -1) << " pointsize 1.3";
  out << ' ' << legend(series.name);
}

std::string script_of(const Chart& chart, const std::string& terminal) {
  std::ostringstream out;
  out.precision(7);
  out << "set encoding utf8\nset terminal " << terminal << '\n';
  out << "set title " << gnuplot_quoted(chart.title) << '\n';
  // Below the data, so that it covers none.
  out << "set key outside below center vertical maxrows " << (chart.series.size() + kLegendColumns - 1) / kLegendColumns
      << " Left reverse samplen 2.5 font ',13'\n";
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
