#include "app/panels/panels.h"

#include <imgui.h>

#include "app/ui/style.h"
#include "app/ui/widgets.h"

namespace fascia {
namespace {

bool while_comparing(const PanelContext& context) { return context.state.comparing; }

const Panel kPanels[] = {{nullptr, true, nullptr, scene_panel},
                         {"Compare", true, while_comparing, compare_panel},
                         {"Material", true, nullptr, material_panel},
                         {"Solver", true, nullptr, solver_panel},
                         {"Convergence", false, nullptr, convergence_panel},
                         {"Display", true, nullptr, display_panel},
                         {"Statistics", true, nullptr, statistics_panel},
                         {"Grab", false, nullptr, grab_panel},
                         {"History", false, nullptr, history_panel},
                         {nullptr, true, nullptr, recording_button}};

}  // namespace

float panel_width() { return ui::px(318); }
float panel_space() { return panel_width() + 2 * ui::px(10); }

Room room_beside_panels(const WindowState& state) {
  const float screen = ImGui::GetIO().DisplaySize.x;
  const bool docked = state.plots.shown && state.plots.docked && state.plots.width > 0;
  return {state.show_panels ? panel_space() : 0, docked ? state.plots.left : screen};
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
    if ((!panel.shown || panel.shown(context)) && (!panel.title || ui::section(panel.title, panel.open_at_first)))
      panel.draw(context);
  ImGui::End();
}

}  // namespace fascia
