#include "app/ui/log_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/ui/style.h"

namespace fascia::ui {
namespace {

struct Frame {
  ImVec2 low, high;         // of the area inside the axes, in pixels
  int most = 1;             // iterations at the right edge
  int bottom = 0, top = 1;  // decades

  float x(std::size_t iteration) const {
    return low.x + (high.x - low.x) * static_cast<float>(iteration) / static_cast<float>(most);
  }
  float y(float value) const {
    const float share = (std::log10(value) - static_cast<float>(bottom)) / static_cast<float>(top - bottom);
    return high.y - (high.y - low.y) * std::clamp(share, 0.0f, 1.0f);
  }
};

Frame fit(const std::vector<Curve>& curves, ImVec2 low, ImVec2 high) {
  Frame frame{low, high};
  float least = 3e38f, most = 0;
  for (const Curve& curve : curves)
    for (std::size_t i = 0; i < curve.values->size(); ++i) {
      const float value = (*curve.values)[i];
      frame.most = std::max(frame.most, static_cast<int>(i));
      if (value <= 0) continue;
      least = std::min(least, value);
      most = std::max(most, value);
    }
  if (most <= 0) return frame;
  frame.bottom = static_cast<int>(std::floor(std::log10(least)));
  frame.top = std::max(frame.bottom + 1, static_cast<int>(std::ceil(std::log10(most))));
  return frame;
}

void draw_axes(ImDrawList& draw, const Frame& frame) {
  const ImU32 grid = ImGui::GetColorU32(ImGuiCol_HeaderHovered), text = ImGui::GetColorU32(kDim);
  const int every = (frame.top - frame.bottom + 4) / 5;
  for (int decade = frame.bottom; decade <= frame.top; decade += every) {
    const float y = frame.y(std::pow(10.0f, static_cast<float>(decade)));
    draw.AddLine({frame.low.x, y}, {frame.high.x, y}, grid);
    char label[16];
    std::snprintf(label, sizeof label, "1e%d", decade);
    draw.AddText({frame.low.x - ImGui::CalcTextSize(label).x - px(4), y - 0.5f * ImGui::GetFontSize()}, text, label);
  }
  const std::string last = std::to_string(frame.most);
  draw.AddText({frame.low.x, frame.high.y + px(2)}, text, "0");
  draw.AddText({frame.high.x - ImGui::CalcTextSize(last.c_str()).x, frame.high.y + px(2)}, text, last.c_str());
  const char* title = "iteration";
  draw.AddText({0.5f * (frame.low.x + frame.high.x - ImGui::CalcTextSize(title).x), frame.high.y + px(2)}, text, title);
}

}  // namespace

void log_plot(const char* id, const std::vector<Curve>& curves, float height) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size{ImGui::GetContentRegionAvail().x, px(height)};
  ImGui::InvisibleButton(id, size);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float line = ImGui::GetFontSize();
  const Frame frame = fit(curves, {corner.x + px(36), corner.y + 0.5f * line},
                          {corner.x + size.x - px(4), corner.y + size.y - line - px(4)});
  draw_axes(draw, frame);
  for (const Curve& curve : curves) {
    const std::vector<float>& values = *curve.values;
    for (std::size_t i = 0; i + 1 < values.size(); ++i)
      if (values[i] > 0 && values[i + 1] > 0)
        draw.AddLine({frame.x(i), frame.y(values[i])}, {frame.x(i + 1), frame.y(values[i + 1])}, curve.color, px(1.5f));
  }
  const float mouse = ImGui::GetIO().MousePos.x;
  if (!ImGui::IsItemHovered() || mouse < frame.low.x || mouse > frame.high.x) return;
  const auto at = static_cast<std::size_t>(
      std::lround((mouse - frame.low.x) / (frame.high.x - frame.low.x) * static_cast<float>(frame.most)));
  draw.AddLine({frame.x(at), frame.low.y}, {frame.x(at), frame.high.y}, ImGui::GetColorU32(kDim));
  ImGui::BeginTooltip();
  ImGui::Text("iteration %zu", at);
  for (const Curve& curve : curves)
    if (at < curve.values->size())
      ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(curve.color), "%.3g", static_cast<double>((*curve.values)[at]));
  ImGui::EndTooltip();
}

ImU32 curve_color(std::size_t index) {
  constexpr ImU32 kColors[] = {IM_COL32(240, 228, 66, 255), IM_COL32(86, 180, 233, 255),  IM_COL32(230, 159, 0, 255),
                               IM_COL32(0, 158, 115, 255),  IM_COL32(204, 121, 167, 255), IM_COL32(213, 94, 0, 255)};
  return kColors[index % std::size(kColors)];
}

}  // namespace fascia::ui
