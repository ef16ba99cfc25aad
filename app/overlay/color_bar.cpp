#include "app/overlay/color_bar.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "app/ui/style.h"
#include "app/ui/ticks.h"
#include "app/ui/units.h"

namespace fascia {
namespace {

constexpr int kBands = 48;  // of the gradient; each is interpolated between its edges, so that no steps are visible

ImU32 color_of(const Eigen::Vector3f& c) { return ImGui::GetColorU32(ImVec4(c.x(), c.y(), c.z(), 1)); }

struct Ink {
  ImVec4 text, line, panel;
};

const ImVec4 kBlack{0.05f, 0.05f, 0.06f, 1}, kWhite{0.95f, 0.95f, 0.96f, 1};

Ink ink_on(Backdrop backdrop) {
  if (backdrop == Backdrop::gradient) return {ui::kText, ui::kDim, ui::kPanel};
  if (backdrop == Backdrop::black) return {kWhite, kWhite, kBlack};
  return {kBlack, kBlack, {1, 1, 1, 1}};
}

// White on dark is readable on any backdrop of a transparent picture; a light plate would contrast with everything but
// white.
Ink ink_of_bar(Backdrop backdrop) { return ink_on(backdrop == Backdrop::transparent ? Backdrop::black : backdrop); }

constexpr float kPad = 10, kEdge = 12;  // inside a plate, and to the picture's edge [points]

// A plate for contents of this size, at the right edge, halfway up. None if it would hide too much of the picture.
std::optional<Box> plate_for(float width, float height, const Box& picture) {
  constexpr float kMostShare = 0.2f;
  width += 2 * ui::px(kPad);
  height += 2 * ui::px(kPad);
  if (width * height > kMostShare * (picture.right - picture.left) * picture.bottom) return std::nullopt;
  const float left = std::floor(picture.right - width - ui::px(kEdge)), top = std::floor((picture.bottom - height) / 2);
  return Box{left, top, left + width, top + height};
}

// Draws the plate and returns the upper left corner of its contents.
ImVec2 draw_plate(ImDrawList& list, const Box& plate, const Ink& ink) {
  list.AddRectFilled({plate.left, plate.top}, {plate.right, plate.bottom},
                     ImGui::GetColorU32(ImVec4(ink.panel.x, ink.panel.y, ink.panel.z, 0.78f)), ui::px(8));
  return {plate.left + ui::px(kPad), plate.top + ui::px(kPad)};
}

// A number without a unit gets as many decimals as the step between ticks.
std::string tick_text(double value, double step, int digits, const std::string& unit) {
  if (std::abs(value) < 1e-9 * step) value = 0;
  const double size = std::max(std::abs(value), step);
  if (!unit.empty() || size < 1e-4 || size >= 1e5) return engineering(value, unit, std::max(digits, 3));
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 8),
                value);
  return text;
}

struct Bar {
  Ticks ticks;
  std::vector<std::string> texts;
  float width, gap, height, above;  // width of the gradient, gap to its numbers, and distance from the title
  std::optional<Box> plate;
};

// Ticks with a number at both ends, if round steps connect them.
Ticks ticks_of(const Eigen::Vector2d& range) {
  constexpr int kUsual = 5;  // intervals
  for (const int most : {kUsual, 4, 3, 2, 6, 7, 8, 9, 10}) {
    const Ticks ticks = linear_ticks(range.x(), range.y(), most);
    const double rounding = 1e-6 * range.cwiseAbs().maxCoeff();
    if (std::abs(ticks.values.front() - range.x()) <= rounding && std::abs(ticks.values.back() - range.y()) <= rounding)
      return ticks;
  }
  return linear_ticks(range.x(), range.y(), kUsual);
}

Bar bar_in(const Box& picture, const Look& look, const Quantity& quantity) {
  Bar bar{ticks_of(look.range.cast<double>()),
          {},
          ui::px(14),
          ui::px(8),
          std::min(ui::px(220), 0.5f * picture.bottom),
          2 * ImGui::GetFontSize(),
          {}};
  const std::vector<double>& ticks = bar.ticks.values;
  // Wide enough that plate and tissue do not move while the range follows the values.
  float text_width = ImGui::CalcTextSize(*quantity.unit ? "-500 kPa" : "-0.05").x;
  for (const double tick : ticks) {
    bar.texts.push_back(tick_text(tick, ticks.size() > 1 ? ticks[1] - ticks[0] : 1, bar.ticks.digits, quantity.unit));
    text_width = std::max(text_width, ImGui::CalcTextSize(bar.texts.back().c_str()).x);
  }
  // Labels extend half a line beyond the bar's ends, and the upper one keeps the same distance from the title.
  const float below = 0.5f * ImGui::GetFontSize();
  bar.plate = plate_for(std::max(bar.width + bar.gap + text_width, ImGui::CalcTextSize(quantity.title).x),
                        bar.above + bar.height + below, picture);
  return bar;
}

void draw_bar(const MarkArea& area, const Look& look, const Quantity& quantity) {
  const Ink ink = ink_of_bar(look.backdrop);
  ImDrawList& list = area.list;
  const Bar bar = bar_in(area.box(), look, quantity);
  if (!bar.plate) return;
  const ImVec2 corner = draw_plate(list, *bar.plate, ink);
  list.AddText(corner, ImGui::GetColorU32(ink.text), quantity.title);

  const std::vector<double>& ticks = bar.ticks.values;
  const float width = bar.width, height = bar.height, gap = bar.gap, line = ImGui::GetFontSize();
  const float left = corner.x, top = corner.y + bar.above;
  const Eigen::Vector2f ends = map_range(look);
  const auto color_at = [&](float share) {
    const float value = look.range.x() + share * (look.range.y() - look.range.x());
    return color_of((*look.color_map)(ends.y() > ends.x() ? (value - ends.x()) / (ends.y() - ends.x()) : 0));
  };
  for (int i = 0; i < kBands; ++i) {
    const float t0 = static_cast<float>(i) / kBands, t1 = static_cast<float>(i + 1) / kBands;
    const ImU32 upper = color_at(1 - t0), lower = color_at(1 - t1);
    list.AddRectFilledMultiColor({left, top + t0 * height}, {left + width, top + t1 * height}, upper, upper, lower,
                                 lower);
  }
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const double share = (ticks[i] - look.range.x()) / (static_cast<double>(look.range.y()) - look.range.x());
    const float y = top + height * (1 - static_cast<float>(share));
    list.AddLine({left + width, y}, {left + width + 0.5f * gap, y}, ImGui::GetColorU32(ink.line), ui::px(1));
    list.AddText({left + width + gap, y - 0.5f * line}, ImGui::GetColorU32(ink.text), bar.texts[i].c_str());
  }
}

struct RegionList {
  std::size_t shown;  // number of names
  std::string more;   // "and 3 more"
  float row, gap;
  std::optional<Box> plate;
};

RegionList regions_in(const Box& picture, const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 16;
  const float line = ImGui::GetFontSize();
  RegionList list{std::min(names.size(), kMost), "", 1.35f * line, ui::px(8), {}};
  if (names.size() > list.shown) list.more = "and " + std::to_string(names.size() - list.shown) + " more";
  float width = ImGui::CalcTextSize(list.more.c_str()).x;
  for (std::size_t i = 0; i < list.shown; ++i)
    width = std::max(width, ImGui::CalcTextSize(names[i].c_str()).x + line + list.gap);
  const float rows = static_cast<float>(list.shown + (list.more.empty() ? 0 : 1));
  list.plate = plate_for(width, rows * list.row - 0.35f * line, picture);
  return list;
}

void draw_regions(const MarkArea& area, const Look& look, const std::vector<std::string>& names) {
  const Ink ink = ink_on(look.backdrop);
  ImDrawList& list = area.list;
  const RegionList regions = regions_in(area.box(), names);
  if (!regions.plate) return;
  ImVec2 at = draw_plate(list, *regions.plate, ink);
  const float line = ImGui::GetFontSize();
  for (std::size_t i = 0; i < regions.shown; ++i, at.y += regions.row) {
    list.AddRectFilled(at, {at.x + line, at.y + line}, color_of(region_color(static_cast<unsigned>(i))), ui::px(2));
    list.AddText({at.x + line + regions.gap, at.y}, ImGui::GetColorU32(ink.text), names[i].c_str());
  }
  list.AddText(at, ImGui::GetColorU32(ink.text), regions.more.c_str());
}

}  // namespace

std::optional<Box> legend_box(const Box& picture, const Session& session) {
  if (session.look.heat_map) return bar_in(picture, session.look, quantity_of(session.display().color)).plate;
  if (const VisualRegions* regions = session.regions()) return regions_in(picture, regions->names).plate;
  return std::nullopt;
}

double legend_space(const Session& session, int width, int height, float scale) {
  const float right = static_cast<float>(width) / scale;
  const auto box = legend_box({0, 0, right, static_cast<float>(height) / scale}, session);
  return box ? std::ceil(scale * (right - box->left)) : 0;
}

void draw_legend(const MarkArea& area, const Session& session) {
  if (session.look.heat_map) draw_bar(area, session.look, quantity_of(session.display().color));
  if (const VisualRegions* regions = session.regions()) draw_regions(area, session.look, regions->names);
}

}  // namespace fascia
