#include "app/bench/figures/picture_grid.h"

#include <algorithm>
#include <sstream>

#include "app/charts/chart.h"
#include "app/charts/gnuplot.h"
#include "render/view/look.h"

namespace fascia {
namespace {

constexpr int kTitle = 56, kCaptionLine = 26, kGap = 12, kScale = 150;  // [pixels]
constexpr int kScaleColors = 32;

struct Layout {
  int columns, rows, width, height, caption;  // of a panel and its caption [pixels]

  explicit Layout(const PictureGrid& grid)
      : columns(std::min(grid.columns, static_cast<int>(grid.panels.size()))),
        rows((static_cast<int>(grid.panels.size()) + columns - 1) / columns),
        width(grid.panels.front().picture.width),
        height(grid.panels.front().picture.height),
        caption(kGap) {
    for (const Panel& panel : grid.panels)
      caption = std::max(caption, kCaptionLine * static_cast<int>(panel.caption.size()) + kGap);
  }
  int canvas_width() const { return kGap + columns * (width + kGap) + kScale; }
  int canvas_height() const { return kTitle + rows * (caption + height) + kGap; }
  int left(int panel) const { return kGap + panel % columns * (width + kGap); }
  int top(int panel) const {
    return kTitle + panel / columns * (caption + height) + caption;
  }  // in the picture, from the top
};

// All pixels of the canvas, top row first, RGB: with the panels on white.
std::string canvas(const PictureGrid& grid, const Layout& layout) {
  std::string pixels(std::size_t{3} * layout.canvas_width() * layout.canvas_height(), '\xff');
  for (int p = 0; p < static_cast<int>(grid.panels.size()); ++p) {
    const std::uint8_t* from = grid.panels[static_cast<std::size_t>(p)].picture.rgba.data();
    for (int y = 0; y < layout.height; ++y) {
      char* to = pixels.data() +
                 std::size_t{3} * (std::size_t{1} * (layout.top(p) + y) * layout.canvas_width() + layout.left(p));
      for (int x = 0; x < layout.width; ++x, from += 4, to += 3) std::copy_n(from, 3, to);
    }
  }
  return pixels;
}

void write_text(std::ostream& out, const std::string& text, int x, int y, const char* style) {
  out << "set label " << gnuplot_quoted(text) << " at first " << x << ", first " << y << " front " << style << '\n';
}

}  // namespace

void write_grid(const std::filesystem::path& path, const PictureGrid& grid) {
  const Layout layout(grid);
  const int w = layout.canvas_width(), h = layout.canvas_height();
  std::ostringstream out;
  out << "set encoding utf8\nset terminal pngcairo size " << w << ',' << h << " noenhanced font 'DejaVu Sans,13'\n";
  // One unit is one pixel, and the plot covers the whole canvas.
  out << "unset tics\nunset border\nunset key\nset xrange [-0.5:" << w - 0.5 << "]\nset yrange [-0.5:" << h - 0.5
      << "]\n"
      << "set lmargin at screen 0\nset rmargin at screen 1\nset bmargin at screen 0\nset tmargin at screen 1\n";
  write_text(out, grid.title, kGap, h - kTitle / 2, "left font 'DejaVu Sans,16'");
  for (int p = 0; p < static_cast<int>(grid.panels.size()); ++p) {
    const std::vector<std::string>& lines = grid.panels[static_cast<std::size_t>(p)].caption;
    for (int l = 0; l < static_cast<int>(lines.size()); ++l)
      write_text(out, lines[static_cast<std::size_t>(l)], layout.left(p),
                 h - layout.top(p) + kGap / 2 + kCaptionLine * (static_cast<int>(lines.size()) - l) - kCaptionLine / 2,
                 "left");
  }
  out << "set palette defined (";
  for (int c = 0; c <= kScaleColors; ++c)
    out << (c ? ", " : "") << c << " '" << gnuplot_color(heat_color(static_cast<float>(c) / kScaleColors)) << '\'';
  out << ")\nset cbrange [" << grid.range.x() << ':' << grid.range.y() << "]\nset cblabel "
      << gnuplot_quoted(grid.scale_label) << "\nset cbtics\nset colorbox user origin screen "
      << double(w - kScale + kGap) / w << ", screen " << 0.15 << " size screen " << 20.0 / w << ", screen 0.6\n";
  out << "plot '-' binary array=(" << w << ',' << h
      << ") flip=y format='%uchar%uchar%uchar' with rgbimage, NaN with lines palette\n";
  out << canvas(grid, layout);
  run_gnuplot(path, out.str());
}

}  // namespace fascia
