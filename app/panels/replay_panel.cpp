// The badge of a playing replay: its progress and its clock, at the top of the picture, where nothing else is drawn.
#include <imgui.h>

#include <cstdio>

#include "app/panels/panels.h"
#include "app/ui/style.h"
#include "app/ui/widgets.h"
#include "sim/replay/replay_time.h"

namespace fascia {

void draw_replay_badge(const Simulation& simulation, WindowState& state, Requests& requests) {
  const ReplayTime time(*simulation.replay());
  const long made = simulation.replayed_steps(), all = simulation.replay()->steps;
  const float left = state.show_panels ? panel_width() : 0;
  ImGui::SetNextWindowPos({(ImGui::GetIO().DisplaySize.x + left) / 2, ui::px(44)}, ImGuiCond_Always, {0.5f, 0});
  if (ImGui::Begin("replay", nullptr,
                   ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                       ImGuiWindowFlags_NoFocusOnAppearing)) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(ui::kAccent, "Replay");
    ImGui::SameLine();
    char text[64];
    std::snprintf(text, sizeof text, "%.1f of %.1f s", time.seconds(made), time.seconds(all));
    ImGui::ProgressBar(static_cast<float>(made) / static_cast<float>(all), {ui::px(150), 0}, text);
    ImGui::SameLine();
    if (ui::button(state.paused ? "Play" : "Pause", ui::px(58), state.paused)) state.paused = !state.paused;
    for (const auto& [label, speed] : {std::pair{"1/4", 0.25}, std::pair{"1x", 1.0}, std::pair{"4x", 4.0}}) {
      ImGui::SameLine();
      if (ui::button(label, ui::px(36), state.replay_speed == speed)) state.replay_speed = speed;
    }
    ImGui::SameLine();
    if (ui::button("Camera", ui::px(66), state.replay_camera)) state.replay_camera = !state.replay_camera;
    ui::tooltip("Uses the recorded camera; turning the view switches it off");
    ImGui::SameLine();
    requests.end_replay |= ui::button("Take over", ui::px(80), false);
    ui::tooltip("Ends the replay, so that the tissue can be grabbed; grabbing the tissue also ends the replay");
  }
  ImGui::End();
}

}  // namespace fascia
