#include "app/color_bar.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/ui_style.h"
#include "app/units.h"
#include "render/look.h"

namespace fascia {
namespace {

constexpr int kBands = 48;  // of the gradient; each is shaded from edge to edge, so steps are not seen

ImU32 color_at(float t) {
  const Eigen::Vector3f c = heat_color(t);
  return ImGui::GetColorU32(ImVec4(c.x(), c.y(), c.z(), 1));
}

}  // namespace

void draw_color_bar(const std::string& label, const Eigen::Vector2f& range) {
  const std::size_t bracket = label.find(" [");
  const std::string title = label.substr(0, bracket);
  std::string unit = bracket == std::string::npos ? "" : label.substr(bracket + 2, label.size() - bracket - 3);
  if (unit == "-") unit.clear();

  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = ui::px(14), gap = ui::px(8), line = ImGui::GetFontSize();
  const float height = std::min(ui::px(220), 0.5f * screen.y), pad = ui::px(10);
  std::string values[3];
  float text_width = 0;
  for (int i = 0; i < 3; ++i) {
    values[i] = engineering(range.x() + 0.5 * i * (range.y() - range.x()), unit);
    text_width = std::max(text_width, ImGui::CalcTextSize(values[i].c_str()).x);
  }
  const float box_width = std::max(width + gap + text_width, ImGui::CalcTextSize(title.c_str()).x) + 2 * pad;
  const float box_height = height + 2 * line + 2 * pad;
  const ImVec2 low{std::floor(screen.x - box_width - ui::px(12)), std::floor((screen.y - box_height) / 2)};
  list.AddRectFilled(low, {low.x + box_width, low.y + box_height},
                     ImGui::GetColorU32(ImVec4(ui::kPanel.x, ui::kPanel.y, ui::kPanel.z, 0.78f)), ui::px(8));
  list.AddText({low.x + pad, low.y + pad}, ImGui::GetColorU32(ui::kText), title.c_str());

  const float left = low.x + pad, top = low.y + pad + 1.5f * line;
  for (int i = 0; i < kBands; ++i) {
    const float t0 = static_cast<float>(i) / kBands, t1 = static_cast<float>(i + 1) / kBands;
    const float y0 = top + t0 * height, y1 = top + t1 * height;
    const ImU32 upper = color_at(1 - t0), lower = color_at(1 - t1);
    list.AddRectFilledMultiColor({left, y0}, {left + width, y1}, upper, upper, lower, lower);
  }
  for (int i = 0; i < 3; ++i) {
    const float y = top + height * (1 - 0.5f * static_cast<float>(i));
    list.AddLine({left + width, y}, {left + width + 0.5f * gap, y}, ImGui::GetColorU32(ui::kDim));
    list.AddText({left + width + gap, y - 0.5f * line}, ImGui::GetColorU32(ui::kText), values[i].c_str());
  }
}

}  // namespace fascia
