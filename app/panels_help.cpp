// Lines over the picture: help, hint, notices, messages.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/panels.h"
#include "app/ui_style.h"
#include "app/ui_widgets.h"
#include "app/units.h"

namespace fascia {
namespace {

constexpr const char* kKeys[][2] = {{"Left drag on tissue", "grab it"},
                                    {"Left drag elsewhere", "orbit"},
                                    {"Shift + left drag", "always grab, the nearest tissue"},
                                    {"Right or middle drag", "pan"},
                                    {"Wheel", "zoom"},
                                    {"F", "frame the scene"},
                                    {"Space", "pause, go on"},
                                    {".", "one step"},
                                    {"R", "reset"},
                                    {"W", "wireframe"},
                                    {"H", "hide the panels"},
                                    {"P", "screenshot (PNG)"},
                                    {"V", "start and stop a video"},
                                    {"Ctrl+O", "open a scene or mesh, or drop it on the window"},
                                    {"Ctrl+S", "save the scene"},
                                    {"F5", "reload the shaders"},
                                    {"Click on a value", "type another, such as 12.5 kPa"},
                                    {"Ctrl+Tab, arrows, Enter", "the panels by keyboard; Esc leaves them"},
                                    {"Ctrl+Q", "quit"},
                                    {"F1", "this list"}};

constexpr ImGuiWindowFlags kPlain = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                    ImGuiWindowFlags_NoFocusOnAppearing;

// Text on a dark pill in the background layer, centered on x; returns its height.
float pill(const std::string& text, float x, float y, const ImVec4& color) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 size = ImGui::CalcTextSize(text.c_str()), pad{ui::px(10), ui::px(5)};
  const ImVec2 low{std::floor(x - size.x / 2 - pad.x), std::floor(y)}, high{low.x + size.x + 2 * pad.x, low.y + size.y + 2 * pad.y};
  list.AddRectFilled(low, high, ImGui::GetColorU32(ImVec4(ui::kPanel.x, ui::kPanel.y, ui::kPanel.z, 0.78f)), ui::px(7));
  list.AddText({low.x + pad.x, low.y + pad.y}, ImGui::GetColorU32(color), text.c_str());
  return high.y - low.y;
}

}  // namespace

void draw_help(ViewState& state) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({(size.x + panel_width()) / 2, size.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  if (ImGui::Begin("Keys and mouse", &state.show_help, (kPlain & ~ImGuiWindowFlags_NoTitleBar) | ImGuiWindowFlags_NoCollapse)) {
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
      for (const auto& [key, action] : kKeys) {
        ImGui::TableNextColumn();
        ImGui::TextColored(ui::kAccent, "%s  ", key);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(action);
      }
      ImGui::EndTable();
    }
  }
  ImGui::End();
}

void draw_hint() {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  pill("Drag the tissue. F1: keys and mouse", (size.x + panel_width()) / 2, size.y - ui::px(40), ui::kDim);
}

void draw_notice(const ViewState& state) {
  const float left = state.show_panels ? panel_width() : 0, middle = (ImGui::GetIO().DisplaySize.x + left) / 2, top = ui::px(14);
  const double speed = state.statistics.speed;
  char text[96];
  if (state.paused) {
    pill("Paused. Space goes on", middle, top, ui::kText);
  } else if (!state.statistics.keeps_pace) {
    std::snprintf(text, sizeof text, "Slower than real time: %.0f %%", std::max(1.0, 100 * speed));
    pill(text, middle, top, ui::kWarning);
  }
}

void draw_force(const Grab& grab) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  pill(engineering(grab.force().norm(), "N"), mouse.x + ui::px(44), mouse.y - ui::px(34), ui::kText);
}

void draw_recording_dot(double seconds) {
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  char text[32];
  std::snprintf(text, sizeof text, "%.1f s", seconds);
  const ImVec2 at{ImGui::GetIO().DisplaySize.x - ui::px(24), ui::px(26)};
  list.AddCircleFilled(at, ui::px(8), ImGui::GetColorU32(ui::kDanger));
  const float width = ImGui::CalcTextSize(text).x;
  list.AddText({at.x - ui::px(16) - width, at.y - ImGui::GetFontSize() / 2}, ImGui::GetColorU32(ui::kDanger), text);
}

bool draw_message(const std::string& text, bool is_error) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({(size.x + panel_width()) / 2, ui::px(56)}, ImGuiCond_Always, {0.5f, 0});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {std::max(ui::px(200), 0.55f * size.x), size.y});
  bool close = false;
  if (is_error) ImGui::PushStyleColor(ImGuiCol_WindowBg, {0.33f, 0.10f, 0.09f, 0.96f});
  if (ImGui::Begin("message", nullptr, kPlain)) {
    ImGui::PushTextWrapPos(std::max(ui::px(180), 0.5f * size.x));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    if (is_error) close = ImGui::Button("Close");
  }
  ImGui::End();
  if (is_error) ImGui::PopStyleColor();
  return close;
}

}  // namespace fascia
