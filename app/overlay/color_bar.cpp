#include "app/overlay/color_bar.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <optional>

#include "app/overlay/color_scale.h"
#include "app/ui/style.h"

namespace fascia {
namespace {

constexpr int kBands = 48;  // of the gradient; each is interpolated between its edges, so that no steps are visible

ImU32 packed(const Eigen::Vector3f& c) { return ImGui::GetColorU32(ImVec4(c.x(), c.y(), c.z(), 1)); }

struct Ink {
  ImVec4 text, line, panel;
};

const ImVec4 kBlack{0.05f, 0.05f, 0.06f, 1}, kWhite{0.95f, 0.95f, 0.96f, 1};

Ink ink_on(Backdrop backdrop, bool plate) {
  if (backdrop == Backdrop::gradient && plate) return {ui::kText, ui::kDim, ui::kPanel};
  if (backdrop == Backdrop::black) return {kWhite, kWhite, kBlack};
  return {kBlack, kBlack, {1, 1, 1, 1}};
}

// White on dark is readable on any backdrop of a transparent picture; a light plate would contrast with everything but
// white. Without a plate the page behind is taken to be light.
Ink ink_of_bar(Backdrop backdrop, bool plate) {
  return ink_on(backdrop == Backdrop::transparent && plate ? Backdrop::black : backdrop, plate);
}

// The legend's own units: all lengths grow with its font.
class Layout {
 public:
  Layout(const Box& picture, float left, const LegendSettings& settings)
      : picture_(picture), left_(left), settings_(settings), font_(ui::legend_font()) {}

  float px(float points) const { return ui::px(points * growth()); }
  float line() const { return font_->FontSize; }
  float width_of(const std::string& text) const {  // whole pixels
    return std::ceil(font_->CalcTextSizeA(line(), FLT_MAX, 0, text.c_str()).x - 1e-5f);
  }
  void write(ImDrawList& list, const ImVec2& at, const ImVec4& color, const std::string& text) const {
    list.AddText(font_, line(), at, ImGui::GetColorU32(color), text.c_str());
  }
  float picture_height() const { return picture_.bottom; }

  // A plate for contents of this size, halfway up. None if it would hide too much of the picture.
  std::optional<Box> plate_for(float width, float height) const {
    const float most_share = std::min(0.2f * std::max(growth(), 1.0f), 0.5f);
    width += 2 * px(kPad);
    height += 2 * px(kPad);
    if (width * height > most_share * (picture_.right - picture_.left) * picture_.bottom) return std::nullopt;
    const float edge = px(kEdge), top = std::floor((picture_.bottom - height) / 2),
                left = settings_.side == LegendSide::left ? std::ceil(picture_.left + left_ + edge)
                                                          : std::floor(picture_.right - width - edge);
    return Box{left, top, left + width, top + height};
  }

  // Draws the plate and returns the upper left corner of its contents.
  ImVec2 draw_plate(ImDrawList& list, const Box& plate, const Ink& ink) const {
    if (settings_.plate)
      list.AddRectFilled({plate.left, plate.top}, {plate.right, plate.bottom},
                         ImGui::GetColorU32(ImVec4(ink.panel.x, ink.panel.y, ink.panel.z, 0.78f)), px(8));
    return {plate.left + px(kPad), plate.top + px(kPad)};
  }

 private:
  static constexpr float kPad = 10, kEdge = 12;  // inside a plate, and to the picture's edge [points]

  float growth() const { return static_cast<float>(settings_.font_size) / ui::kFontSize; }

  Box picture_;
  float left_;
  const LegendSettings& settings_;
  ImFont* font_;
};

struct Bar {
  float width, gap, height, above;  // width of the gradient, gap to its numbers, and distance from the title
  std::optional<Box> plate;
};

Bar bar_in(const Layout& layout, const ColorScale& scale, const Quantity& quantity) {
  Bar bar{layout.px(14), layout.px(8), std::min(layout.px(220), 0.5f * layout.picture_height()), 2 * layout.line(), {}};
  // Wide enough that plate and tissue do not move while the range follows the values.
  float text_width = layout.width_of(*quantity.unit ? "-500 kPa" : "-0.05");
  for (const ColorScale::Tick& tick : scale.ticks) text_width = std::max(text_width, layout.width_of(tick.text));
  // Labels extend half a line beyond the bar's ends, and the upper one keeps the same distance from the title.
  const float below = 0.5f * layout.line();
  bar.plate = layout.plate_for(std::max(bar.width + bar.gap + text_width, layout.width_of(scale.title)),
                               bar.above + bar.height + below);
  return bar;
}

// A range that is not known yet has no numbers.
ColorScale scale_of(const Session& session) {
  ColorScale scale = color_scale(session.look, quantity_of(session.display().color), session.beyond_range());
  if (!session.has_range()) scale.ticks.clear();
  return scale;
}

void draw_bar(const MarkArea& area, const Layout& layout, const Session& session) {
  const Look& look = session.look;
  const Ink ink = ink_of_bar(look.backdrop, session.display().legend.plate);
  ImDrawList& list = area.list;
  const ColorScale scale = scale_of(session);
  const Bar bar = bar_in(layout, scale, quantity_of(session.display().color));
  if (!bar.plate) return;
  const ImVec2 corner = layout.draw_plate(list, *bar.plate, ink);
  layout.write(list, corner, ink.text, scale.title);

  const float width = bar.width, height = bar.height, gap = bar.gap;
  const float left = corner.x, top = corner.y + bar.above;
  for (int i = 0; i < kBands; ++i) {
    const float t0 = static_cast<float>(i) / kBands, t1 = static_cast<float>(i + 1) / kBands;
    const ImU32 upper = packed(color_at(look, 1 - t0)), lower = packed(color_at(look, 1 - t1));
    list.AddRectFilledMultiColor({left, top + t0 * height}, {left + width, top + t1 * height}, upper, upper, lower,
                                 lower);
  }
  const float point = 0.6f * width;  // of the arrows at the ends
  for (const int end : {0, 1}) {
    if (!scale.beyond[static_cast<std::size_t>(end)]) continue;
    const float base = end ? top : top + height, tip = end ? base - point : base + point;
    list.AddTriangleFilled({left, base}, {left + width, base}, {left + 0.5f * width, tip},
                           packed(color_at(look, static_cast<float>(end))));
  }
  for (const ColorScale::Tick& tick : scale.ticks) {
    const float y = top + height * (1 - static_cast<float>(tick.share));
    list.AddLine({left + width, y}, {left + width + 0.5f * gap, y}, ImGui::GetColorU32(ink.line), layout.px(1));
    layout.write(list, {left + width + gap, y - 0.5f * layout.line()}, ink.text, tick.text);
  }
}

struct RegionList {
  std::size_t shown;  // number of names
  std::string more;   // "and 3 more"
  float row, gap;
  std::optional<Box> plate;
};

RegionList regions_in(const Layout& layout, const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 16;
  const float line = layout.line();
  RegionList list{std::min(names.size(), kMost), "", 1.35f * line, layout.px(8), {}};
  if (names.size() > list.shown) list.more = "and " + std::to_string(names.size() - list.shown) + " more";
  float width = layout.width_of(list.more);
  for (std::size_t i = 0; i < list.shown; ++i) width = std::max(width, layout.width_of(names[i]) + line + list.gap);
  const float rows = static_cast<float>(list.shown + (list.more.empty() ? 0 : 1));
  list.plate = layout.plate_for(width, rows * list.row - 0.35f * line);
  return list;
}

void draw_regions(const MarkArea& area, const Layout& layout, const Session& session,
                  const std::vector<std::string>& names) {
  const Ink ink = ink_on(session.look.backdrop, session.display().legend.plate);
  ImDrawList& list = area.list;
  const RegionList regions = regions_in(layout, names);
  if (!regions.plate) return;
  ImVec2 at = layout.draw_plate(list, *regions.plate, ink);
  const float line = layout.line();
  for (std::size_t i = 0; i < regions.shown; ++i, at.y += regions.row) {
    list.AddRectFilled(at, {at.x + line, at.y + line}, packed(region_color(static_cast<unsigned>(i))), layout.px(2));
    layout.write(list, {at.x + line + regions.gap, at.y}, ink.text, names[i]);
  }
  layout.write(list, at, ink.text, regions.more);
}

}  // namespace

std::optional<Box> legend_box(const Box& picture, const Session& session, float left) {
  if (!has_legend(session)) return std::nullopt;
  const Layout layout(picture, left, session.display().legend);
  if (session.look.heat_map) return bar_in(layout, scale_of(session), quantity_of(session.display().color)).plate;
  if (const VisualRegions* regions = session.regions()) return regions_in(layout, regions->names).plate;
  return std::nullopt;
}

Margins legend_margins(const Session& session, int width, int height, float scale, double panels) {
  Margins margins{panels};
  const Box picture{0, 0, static_cast<float>(width) / scale, static_cast<float>(height) / scale};
  const float left = static_cast<float>(panels) / scale;
  const auto box = legend_box(picture, session, left);
  if (!box) return margins;
  if (session.display().legend.side == LegendSide::left)
    margins.legend_left = std::ceil(scale * (box->right - left));
  else
    margins.right = std::ceil(scale * (picture.right - box->left));
  return margins;
}

void draw_legend(const MarkArea& area, const Session& session, float left) {
  if (!has_legend(session)) return;
  const Layout layout(area.box(), left, session.display().legend);
  if (session.look.heat_map) draw_bar(area, layout, session);
  if (const VisualRegions* regions = session.regions()) draw_regions(area, layout, session, regions->names);
}

}  // namespace fascia
