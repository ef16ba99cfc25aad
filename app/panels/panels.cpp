#include "app/panels/panels.h"

#include <imgui.h>

#include <cstring>
#include <functional>

#include "app/ui/style.h"
#include "app/ui/widgets.h"

namespace fascia {
namespace {

bool while_comparing(const PanelContext& context) { return context.state.comparing; }

// The panels of a tab follow each other.
const Panel kPanels[] = {
    {nullptr, nullptr, true, nullptr, scene_panel},        {nullptr, "Compare", true, while_comparing, compare_panel},
    {"Tissue", "Material", true, nullptr, material_panel}, {"Tissue", "Grab", true, nullptr, grab_panel},
    {"Tissue", "Brush", true, nullptr, brush_panel},       {"Instruments", nullptr, true, nullptr, instruments_panel},
    {"Solver", "Solver", true, nullptr, solver_panel},     {"Solver", "Convergence", false, nullptr, convergence_panel},
    {"Display", nullptr, true, nullptr, display_panel},    {"Data", "Statistics", true, nullptr, statistics_panel},
    {"Data", "History", true, nullptr, history_panel}};

void draw_panel(const Panel& panel, const PanelContext& context) {
  if ((!panel.shown || panel.shown(context)) && (!panel.title || ui::section(panel.title, panel.open_at_first)))
    panel.draw(context);
}

// Tabs so narrow that all names fit into the column.
bool narrow(const std::function<bool()>& begin) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui::px(3), ImGui::GetStyle().FramePadding.y});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, {ui::px(2), ImGui::GetStyle().ItemInnerSpacing.y});
  const bool began = begin();
  ImGui::PopStyleVar(2);
  return began;
}

// The panels of one tab, which scroll while the tabs and what is above them stay.
void draw_tab(const char* tab, const PanelContext& context) {
  if (!narrow([&] { return ImGui::BeginTabItem(tab); })) return;
  ImGui::BeginChild("panels of the tab", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  for (const Panel& panel : kPanels)
    if (panel.tab && std::strcmp(panel.tab, tab) == 0) draw_panel(panel, context);
  ImGui::EndChild();
  ImGui::EndTabItem();
}

}  // namespace

float panel_width() { return ui::px(318); }
float panel_space() { return panel_width() + 2 * ui::px(10); }

Cover cover_of(const WindowState& state) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const Plots& plots = state.plots;
  const bool docked = plots.shown && plots.docked && plots.width > 0;
  return {docked && !plots.at_bottom ? screen.x - plots.left : 0,
          docked && plots.at_bottom ? screen.y - plots.top : state.gallery_height};
}

Room room_beside_panels(const WindowState& state) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const Cover cover = cover_of(state);
  return {state.show_panels ? panel_space() : 0, screen.x - cover.right, screen.y - cover.bottom};
}

std::span<const Panel> panels() { return kPanels; }

void draw_panels(const PanelContext& context) {
  const float margin = ui::px(10);
  ImGui::SetNextWindowPos({margin, margin});
  ImGui::SetNextWindowSize({panel_width(), ImGui::GetIO().DisplaySize.y - 2 * margin});
  ImGui::Begin("panels", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
  context.state.show_convergence = false;  // the panel sets it when drawn
  for (const Panel& panel : kPanels)
    if (!panel.tab) draw_panel(panel, context);
  if (narrow([] { return ImGui::BeginTabBar("tabs"); })) {
    const char* last = nullptr;
    for (const Panel& panel : kPanels)
      if (panel.tab && (!last || std::strcmp(panel.tab, last) != 0)) draw_tab(last = panel.tab, context);
    ImGui::EndTabBar();
  }
  ImGui::End();
}

}  // namespace fascia
