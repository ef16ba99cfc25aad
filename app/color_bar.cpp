#include "app/color_bar.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "app/ticks.h"
#include "app/ui_style.h"
#include "app/units.h"

namespace fascia {
namespace {

constexpr int kBands = 48;  // of the gradient; each is shaded from edge to edge, so steps are not seen

ImU32 color_of(const Eigen::Vector3f& c) { return ImGui::GetColorU32(ImVec4(c.x(), c.y(), c.z(), 1)); }

struct Ink {
  ImVec4 text, line, panel;
};

Ink ink_on(Backdrop backdrop) {
  const ImVec4 black{0.05f, 0.05f, 0.06f, 1}, white{0.95f, 0.95f, 0.96f, 1};
  if (backdrop == Backdrop::gradient) return {ui::kText, ui::kDim, ui::kPanel};
  if (backdrop == Backdrop::black) return {white, white, black};
  return {black, black, {1, 1, 1, 1}};
}

// A box at the right edge, half way up; its upper left corner inside the padding. None where it would hide too much of the picture.
std::optional<ImVec2> place(ImDrawList& list, float width, float height, const Ink& ink) {
  constexpr float kMostShare = 0.2f;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float pad = ui::px(10), box_width = width + 2 * pad, box_height = height + 2 * pad;
  if (box_width * box_height > kMostShare * screen.x * screen.y) return std::nullopt;
  const ImVec2 low{std::floor(screen.x - box_width - ui::px(12)), std::floor((screen.y - box_height) / 2)};
  list.AddRectFilled(low, {low.x + box_width, low.y + box_height}, ImGui::GetColorU32(ImVec4(ink.panel.x, ink.panel.y, ink.panel.z, 0.78f)),
                     ui::px(8));
  return ImVec2{low.x + pad, low.y + pad};
}

// A number without a unit gets as many decimals as its step has.
std::string tick_text(double value, double step, int digits, const std::string& unit) {
  if (std::abs(value) < 1e-9 * step) value = 0;
  const double size = std::max(std::abs(value), step);
  if (!unit.empty() || size < 1e-4 || size >= 1e5) return engineering(value, unit, std::max(digits, 3));
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 8), value);
  return text;
}

void draw_bar(const Look& look, const Quantity& quantity) {
  const Ink ink = ink_on(look.backdrop);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float width = ui::px(14), gap = ui::px(8), line = ImGui::GetFontSize();
  const float height = std::min(ui::px(220), 0.5f * ImGui::GetIO().DisplaySize.y);
  constexpr int kIntervals = 5;
  const Ticks scale = linear_ticks(look.range.x(), look.range.y(), kIntervals);
  const std::vector<double>& ticks = scale.values;
  std::vector<std::string> texts;
  float text_width = 0;
  for (const double tick : ticks) {
    texts.push_back(tick_text(tick, ticks.size() > 1 ? ticks[1] - ticks[0] : 1, scale.digits, quantity.unit));
    text_width = std::max(text_width, ImGui::CalcTextSize(texts.back().c_str()).x);
  }
  // Labels reach half a line over the bar's ends, and the upper one stays as much below the title.
  const float above = 2 * line, below = 0.5f * line;
  const auto corner = place(list, std::max(width + gap + text_width, ImGui::CalcTextSize(quantity.title).x), above + height + below, ink);
  if (!corner) return;
  list.AddText(*corner, ImGui::GetColorU32(ink.text), quantity.title);

  const float left = corner->x, top = corner->y + above;
  const Eigen::Vector2f ends = map_range(look);
  const auto color_at = [&](float share) {
    const float value = look.range.x() + share * (look.range.y() - look.range.x());
    return color_of((*look.color_map)(ends.y() > ends.x() ? (value - ends.x()) / (ends.y() - ends.x()) : 0));
  };
  for (int i = 0; i < kBands; ++i) {
    const float t0 = static_cast<float>(i) / kBands, t1 = static_cast<float>(i + 1) / kBands;
    const ImU32 upper = color_at(1 - t0), lower = color_at(1 - t1);
    list.AddRectFilledMultiColor({left, top + t0 * height}, {left + width, top + t1 * height}, upper, upper, lower, lower);
  }
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const float y = top + height * (1 - (static_cast<float>(ticks[i]) - look.range.x()) / (look.range.y() - look.range.x()));
    list.AddLine({left + width, y}, {left + width + 0.5f * gap, y}, ImGui::GetColorU32(ink.line), ui::px(1));
    list.AddText({left + width + gap, y - 0.5f * line}, ImGui::GetColorU32(ink.text), texts[i].c_str());
  }
}

void draw_regions(const Look& look, const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 16;
  const std::size_t shown = std::min(names.size(), kMost);
  const std::string more = names.size() > shown ? "and " + std::to_string(names.size() - shown) + " more" : "";
  const Ink ink = ink_on(look.backdrop);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float line = ImGui::GetFontSize(), row = 1.35f * line, gap = ui::px(8);
  float width = ImGui::CalcTextSize(more.c_str()).x;
  for (std::size_t i = 0; i < shown; ++i) width = std::max(width, ImGui::CalcTextSize(names[i].c_str()).x + line + gap);
  const float rows = static_cast<float>(shown + (more.empty() ? 0 : 1));
  const auto corner = place(list, width, rows * row - 0.35f * line, ink);
  if (!corner) return;
  ImVec2 at = *corner;
  for (std::size_t i = 0; i < shown; ++i, at.y += row) {
    list.AddRectFilled(at, {at.x + line, at.y + line}, color_of(region_color(static_cast<unsigned>(i))), ui::px(2));
    list.AddText({at.x + line + gap, at.y}, ImGui::GetColorU32(ink.text), names[i].c_str());
  }
  list.AddText(at, ImGui::GetColorU32(ink.text), more.c_str());
}

}  // namespace

void draw_legend(const Session& session) {
  if (session.look.heat_map) draw_bar(session.look, quantity_of(session.display().color));
  if (const DrawnRegions* regions = session.regions()) draw_regions(session.look, regions->names);
}

}  // namespace fascia
