// Lines over the picture: help, hint, notices, messages.
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "app/panels/panels.h"
#include "app/ui/style.h"
#include "app/ui/widgets.h"

namespace fascia {
namespace {

struct Key {
  const char *key, *does;
};
struct Theme {
  const char* name;
  std::vector<Key> keys;
};

// Columns of the list, each with a few themes one below the other.
const std::vector<std::vector<Theme>>& help_columns() {
  static const std::vector<std::vector<Theme>> columns = {
      {{"Mouse",
        {{"Left drag on tissue", "grab it"},
         {"Left drag elsewhere", "orbit"},
         {"Shift + left drag", "always grab, the nearest tissue"},
         {"Alt + left drag", "push the tissue in; X: push without Alt"},
         {"Ctrl + left drag", "move the section plane, if any"},
         {"Right or middle drag", "pan"},
         {"Wheel", "zoom"}}},
       {"Grabs",
        {{"[ ], Ctrl + wheel", "size of the patch"},
         {"Wheel while dragging", "away and closer; pushing: deeper"},
         {"T, or Ctrl on release", "the grab stays there"},
         {"Left, right on its mark", "take it up again, let it go"},
         {"Delete, Esc", "let go of one that stays, of all"},
         {"Esc", "put the brush away"}}},
       {"Time", {{"Space", "pause, go on"}, {".", "one step"}, {"R", "reset"}}},
       {"Values",
        {{"Click on a value", "type another, such as 12.5 kPa"},
         {"Ctrl+Z, Ctrl+Y", "undo a change, redo it"},
         {"B", "compare two settings side by side"},
         {"Ctrl+Tab, arrows, Enter", "the panels by keyboard; Esc leaves them"}}}},
      {{"View", {{"F", "frame the body"}, {"W", "wireframe"}, {"H", "hide the panels"}, {"F3", "plots over time"}}},
       {"Instruments",
        {{"Tab, click on one", "take it in hand, the next one, none"},
         {"Left, right drag", "move it, turn it"},
         {"Wheel", "away and closer"},
         {"G, Shift + G held", "close jaws, open them"},
         {"Alt + wheel", "zoom with one in hand"},
         {"Esc", "let go of it: it stays there"}}},
       {"Files",
        {{"Ctrl+O", "open; or drop a file on the window"},
         {"Ctrl+Shift+O", "recent files"},
         {"F2", "examples"},
         {"Ctrl+S", "save the scene"},
         {"Ctrl+Shift+C", "copy the command line of the current scene"},
         {"Ctrl+E", "export the state: .vtu .csv .msh .obj .inp"},
         {"P", "screenshot (PNG)"},
         {"V, Shift+V", "start and stop a video; video settings"},
         {"Ctrl+R", "save a replay of this session"}}},
       {"Program", {{"F1", "this list"}, {"F5", "reload the shaders"}, {"Ctrl+Q", "quit"}}}}};
  return columns;
}

constexpr ImGuiWindowFlags kPlain = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                    ImGuiWindowFlags_NoFocusOnAppearing;

}  // namespace

void draw_help(WindowState& state) {
  // Centred beside the panels. If the window does not fit there, it covers them and scrolls.
  const char* name = "Keys and mouse";
  const ImVec2 size = ImGui::GetIO().DisplaySize, most{size.x - ui::px(16), size.y - ui::px(16)};
  const ImGuiWindow* before = ImGui::FindWindowByName(name);
  const float half = before ? before->Size.x / 2 : 0, right_most = size.x - ui::px(8) - half;
  ImGui::SetNextWindowPos({std::min((size.x + panel_width()) / 2, right_most), size.y / 2}, ImGuiCond_Always,
                          {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({0, 0}, most);
  ImGui::SetNextWindowBgAlpha(0.98f);  // plots may lie below
  constexpr ImGuiWindowFlags kFlags =
      (kPlain & ~ImGuiWindowFlags_NoTitleBar) | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_HorizontalScrollbar;
  if (ImGui::Begin(name, &state.show_help, kFlags)) {
    const auto& columns = help_columns();
    constexpr float kTwoColumns = 900;  // a narrower picture has them one below the other, and scrolls [points]
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (c > 0 && size.x >= ui::px(kTwoColumns)) ImGui::SameLine(0, ui::px(28));
      ImGui::BeginGroup();
      for (const Theme& theme : columns[c]) {
        ImGui::PushFont(ui::bold_font());
        ImGui::TextUnformatted(theme.name);
        ImGui::PopFont();
        if (ImGui::BeginTable(theme.name, 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoHostExtendX)) {
          for (const Key& key : theme.keys) {
            ImGui::TableNextColumn();
            ImGui::TextColored(ui::kAccent, "%s  ", key.key);
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(key.does);
          }
          ImGui::EndTable();
        }
        ImGui::Spacing();
      }
      ImGui::EndGroup();
    }
  }
  ImGui::End();
}

std::vector<HintLine> hint_lines(const Hints& hints, bool in_hand) {
  std::vector<HintLine> lines;
  if (hints.wanted("help")) lines.push_back({"F1: all keys, F2: examples", true});
  if (hints.wanted("orbit"))
    lines.push_back({in_hand ? "Alt + drag beside the tissue to turn the view, Alt + wheel: zoom"
                             : "Drag beside it to turn the view, wheel: zoom",
                     false});
  if (hints.wanted("grab"))
    lines.push_back(
        {in_hand ? "Drag to move the instrument, right drag to turn it" : "Drag the tissue to pull at it", false});
  else if (hints.wanted("tune"))
    lines.push_back({"Move a slider: the tissue changes at once", false});
  return lines;
}

void draw_hints(const Hints& hints, bool in_hand, const Room& room) {
  if (room.width() < ui::px(330) || room.bottom < ui::px(400)) return;  // they do not fit
  float below = room.bottom - ui::px(40);
  for (const HintLine& line : hint_lines(hints, in_hand)) {
    ui::pill(line.text, room.middle(), below, line.dim ? ui::kDim : ui::kText);
    below -= ui::px(36);
  }
}

void draw_recovery(const std::string& scene, const Room& room, Requests& requests) {
  const std::string text = "fascia closed unexpectedly while " + scene + " was open.";
  const ImGuiStyle& style = ImGui::GetStyle();
  const float buttons = ImGui::CalcTextSize("RestoreDiscard").x + 4 * style.FramePadding.x + style.ItemSpacing.x,
              one_line =
                  ImGui::CalcTextSize(text.c_str()).x + style.ItemSpacing.x + buttons + 2 * style.WindowPadding.x,
              most = room.width() - ui::px(20);
  ImGui::SetNextWindowPos({room.middle(), ui::px(50)}, ImGuiCond_Always, {0.5f, 0});
  if (ImGui::Begin("recovery", nullptr, kPlain)) {
    // In front of plots, but not of dialogs.
    if (!ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
      ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
    ImGui::AlignTextToFramePadding();
    ImGui::PushTextWrapPos(std::max(ui::px(120), most - style.WindowPadding.x));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    if (one_line <= most) ImGui::SameLine();
    requests.resume_recovered |= ImGui::Button("Restore");
    ui::tooltip("Opens that scene with its last state");
    ImGui::SameLine();
    requests.forget_recovered |= ImGui::Button("Discard");
    ui::tooltip("Deletes that scene's last state; this cannot be undone");
  }
  ImGui::End();
}

void draw_notice(const WindowState& state, const Room& room) {
  constexpr double kUnnoticed = 0.3;  // [s]
  const bool fits = room.width() > ui::px(230);
  const float middle = fits ? room.middle() : 0.5f * (room.left + ImGui::GetIO().DisplaySize.x), top = ui::px(14);
  const double speed = state.statistics.speed;
  char text[96];
  if (state.paused) {
    ui::pill("Paused. Space resumes", middle, top, ui::kText);
  } else if (state.statistics.waits > kUnnoticed) {
    ui::pill("Getting the solver ready", middle, top, ui::kText);
  } else if (!state.statistics.keeps_pace) {
    const bool passes = state.statistics.compiling;
    const auto say = [&](const char* reason) {
      std::snprintf(text, sizeof text, "Slower than real time%s: %.0f %%", reason, std::max(1.0, 100 * speed));
    };
    say(passes ? " while kernels compile" : "");
    if (ImGui::CalcTextSize(text).x > room.width() - ui::px(40)) say("");
    ui::pill(text, middle, top, passes ? ui::kText : ui::kWarning);
  }
}

void draw_recording_dot(double seconds, long dropped) {
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  char text[64];
  const int length = std::snprintf(text, sizeof text, "%.1f s", seconds);
  if (dropped > 0)
    std::snprintf(text + length, sizeof text - static_cast<std::size_t>(length), ", repeated frames: %ld", dropped);
  const ImVec2 at{ImGui::GetIO().DisplaySize.x - ui::px(24), ui::px(26)};
  list.AddCircleFilled(at, ui::px(8), ImGui::GetColorU32(ui::kDanger));
  const float width = ImGui::CalcTextSize(text).x;
  const float left = at.x - ui::px(16) - width, half = ImGui::GetFontSize() / 2;
  list.AddText({left, at.y - half}, ImGui::GetColorU32(ui::kDanger), text);
  ui::keep_clear({left, at.y - half, at.x + ui::px(8), at.y + half});
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
    if (is_error) {
      close = ImGui::Button("Close (Esc)");
      close |= ImGui::IsMouseHoveringRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax()) &&
               ImGui::IsMouseClicked(0);  // works in front of a dialog, too
      ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
    }
  }
  ImGui::End();
  if (is_error) ImGui::PopStyleColor();
  return close;
}

}  // namespace fascia
