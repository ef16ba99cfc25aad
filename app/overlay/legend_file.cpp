#include "app/overlay/legend_file.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "app/charts/chart.h"
#include "app/charts/gnuplot.h"
#include "app/overlay/color_scale.h"
#include "base/file.h"

namespace fascia {
namespace {

constexpr int kColors = 64;                                   // of the gradient, which gnuplot interpolates
constexpr double kLetter = 0.58;                              // mean width of a letter of the font, in its size
constexpr double kBarWidth = 1, kBarHeight = 15, kPad = 0.6;  // in sizes of the font

// A script whose unit is the size of the font, from the lower left corner.
class Sheet {
 public:
  Sheet(const std::filesystem::path& path, double font, double width, double height) {
    const bool pdf = lower_ending(path) == ".pdf";
    constexpr double kInch = 72;  // [points]
    out_ << "set encoding utf8\nset terminal ";
    if (pdf)  // which draws letters a third larger than their points
      out_ << "pdfcairo size " << font * width / kInch << "in," << font * height / kInch << "in fontscale 0.75";
    else
      out_ << "svg size " << font * width << ',' << font * height << " fixed";
    out_ << " noenhanced font 'DejaVu Sans," << font << "'\n"
         << "unset tics\nunset border\nunset key\nset xrange [0:" << width << "]\nset yrange [0:" << height << "]\n"
         << "set lmargin at screen 0\nset rmargin at screen 1\nset bmargin at screen 0\nset tmargin at screen 1\n";
    width_ = width;
    height_ = height;
  }

  void text(double x, double y, const std::string& text) {
    out_ << "set label " << gnuplot_quoted(text) << " at first " << x << ", first " << y << " left\n";
  }
  void line(double x, double y, double length) {
    out_ << "set arrow from first " << x << ", first " << y << " rto first " << length
         << ", first 0 nohead linecolor rgb 'black' linewidth 1\n";
  }
  void square(double x, double y, double size, const Eigen::Vector3f& color) {
    area({{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}}, color);
  }
  void area(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector3f& color) {
    out_ << "set object polygon from";
    for (const Eigen::Vector2d& corner : corners) out_ << " first " << corner.x() << ", first " << corner.y() << " to";
    out_ << " first " << corners.front().x() << ", first " << corners.front().y() << " fillcolor rgb '"
         << gnuplot_color(color) << "' fillstyle solid noborder\n";
  }
  void gradient(double x, double y, double width, double height, const Look& look) {
    out_ << "set palette defined (";
    for (int c = 0; c <= kColors; ++c)
      out_ << (c ? ", " : "") << c << " '" << gnuplot_color(color_at(look, static_cast<float>(c) / kColors)) << '\'';
    out_ << ")\nset cbrange [0:1]\nset colorbox user noborder origin screen " << x / width_ << ", screen "
         << y / height_ << " size screen " << width / width_ << ", screen " << height / height_ << '\n';
  }
  std::string script() const { return out_.str() + "plot NaN with lines palette\n"; }

 private:
  std::ostringstream out_;
  double width_ = 0, height_ = 0;
};

double width_of(const std::string& text) { return kLetter * static_cast<double>(text.size()); }

std::string bar_script(const std::filesystem::path& path, const Session& session, double font) {
  const ColorScale scale = color_scale(session.look, quantity_of(session.display().color), session.beyond_range());
  constexpr double kGap = 0.6, kArrow = 0.6 * kBarWidth, kTitle = 2;
  double labels = 0;
  for (const ColorScale::Tick& tick : scale.ticks) labels = std::max(labels, width_of(tick.text));
  const double width = 2 * kPad + std::max(kBarWidth + kGap + labels, width_of(scale.title)), bottom = kPad + kArrow,
               top = bottom + kBarHeight, left = kPad;
  Sheet sheet(path, font, width, top + kTitle + kPad);
  sheet.text(left, top + kTitle - 0.3, scale.title);
  sheet.gradient(left, bottom, kBarWidth, kBarHeight, session.look);
  for (const int end : {0, 1}) {
    if (!scale.beyond[static_cast<std::size_t>(end)]) continue;
    const double base = end ? top : bottom, tip = end ? top + kArrow : bottom - kArrow;
    sheet.area({{left, base}, {left + kBarWidth, base}, {left + 0.5 * kBarWidth, tip}},
               color_at(session.look, static_cast<float>(end)));
  }
  for (const ColorScale::Tick& tick : scale.ticks) {
    const double y = bottom + tick.share * kBarHeight;
    sheet.line(left + kBarWidth, y, 0.5 * kGap);
    sheet.text(left + kBarWidth + kGap, y, tick.text);
  }
  return sheet.script();
}

std::string regions_script(const std::filesystem::path& path, const std::vector<std::string>& names, double font) {
  constexpr double kRow = 1.5, kGap = 0.6;
  double widest = 0;
  for (const std::string& name : names) widest = std::max(widest, width_of(name));
  const double height = 2 * kPad + kRow * static_cast<double>(names.size());
  Sheet sheet(path, font, 2 * kPad + 1 + kGap + widest, height);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double middle = height - kPad - kRow * (static_cast<double>(i) + 0.5);
    sheet.square(kPad, middle - 0.5, 1, region_color(static_cast<unsigned>(i)));
    sheet.text(kPad + 1 + kGap, middle, names[i]);
  }
  return sheet.script();
}

}  // namespace

bool has_legend_file(const Session& session) { return session.look.heat_map || session.regions(); }

void write_legend(const std::filesystem::path& path, const Session& session) {
  const double font = session.display().legend.font_size;
  if (const VisualRegions* regions = session.regions())
    run_gnuplot(path, regions_script(path, regions->names, font), "Regions");
  else
    run_gnuplot(path, bar_script(path, session, font), quantity_of(session.display().color).title);
}

}  // namespace fascia
