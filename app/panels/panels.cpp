#include "app/panels/panels.h"

#include <imgui.h>

#include "app/ui/style.h"
#include "app/ui/widgets.h"

namespace fascia {

float panel_width() { return ui::px(318); }
float panel_space() { return panel_width() + 2 * ui::px(10); }

Room room_beside_panels(const WindowState& state) {
  const float screen = ImGui::GetIO().DisplaySize.x;
  const bool docked = state.plots.shown && state.plots.docked && state.plots.width > 0;
  return {state.show_panels ? panel_space() : 0, docked ? state.plots.left : screen};
}

void draw_panels(Session& session, WindowState& state, Requests& requests) {
  const float margin = ui::px(10);
  ImGui::SetNextWindowPos({margin, margin});
  ImGui::SetNextWindowSize({panel_width(), ImGui::GetIO().DisplaySize.y - 2 * margin});
  ImGui::Begin("panels", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
  scene_panel(session, state, requests);
  if (state.comparing && ui::section("Compare")) compare_panel(state, requests);
  if (ui::section("Material")) material_panel(session.simulation, state, requests);
  if (ui::section("Solver")) solver_panel(session, state);
  state.show_convergence = ui::section("Convergence", false);
  if (state.show_convergence) convergence_panel(session.simulation, state.convergence);
  if (ui::section("Display")) display_panel(session);
  if (ui::section("Statistics")) statistics_panel(session, state);
  if (ui::section("Grab", false)) grab_panel(session, state, requests);
  if (ui::section("History", false)) history_panel(state.history, requests);
  if (ui::button("Recording...", ImGui::GetContentRegionAvail().x, state.show_recording))
    state.show_recording = !state.show_recording;
  ui::tooltip("What videos are to be (Shift+V), and a replay of this session");
  ImGui::End();
}

}  // namespace fascia
