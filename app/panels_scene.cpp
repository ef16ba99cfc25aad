// The top of the column: what is open, files, and the buttons of the clock.
#include <imgui.h>

#include <cstdio>

#include "app/panels.h"
#include "app/ui_style.h"
#include "app/ui_widgets.h"
#include "app/units.h"

namespace fascia {
namespace {

std::string grouped(std::size_t number) {  // 12345 as 12 345
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, " ");
  return text;
}

// Buttons of equal width in one row.
class ButtonRow {
 public:
  explicit ButtonRow(int count)
      : width_((ImGui::GetContentRegionAvail().x - static_cast<float>(count - 1) * ImGui::GetStyle().ItemSpacing.x) / static_cast<float>(count)) {}
  bool add(const char* text, const char* help, bool lit = false) {
    if (!first_) ImGui::SameLine();
    first_ = false;
    const bool pressed = ui::button(text, width_, lit);
    ui::tooltip(help);
    return pressed;
  }

 private:
  float width_;
  bool first_ = true;
};

}  // namespace

void scene_panel(const Session& session, ViewState& state, Requests& requests) {
  const Simulation& simulation = session.simulation;
  const Scene& scene = simulation.scene;
  ImGui::PushFont(ui::bold_font());
  ImGui::TextWrapped("%s", scene.title.empty() ? scene.file.stem().string().c_str() : scene.title.c_str());
  ImGui::PopFont();
  ui::tooltip(scene.file.string());

  ButtonRow files(3);
  requests.open_dialog |= files.add("Open...", "A scene, a mesh or a replay (Ctrl+O, or drop a file on the window)");
  requests.save_dialog |= files.add("Save...", "This scene with the values of the sliders, as JSON (Ctrl+S)");
  if (files.add("Help", "Keys and mouse (F1)", state.show_help)) state.show_help = !state.show_help;
  ButtonRow more(3);
  requests.recent |= more.add("Recent", "What was opened before (Ctrl+Shift+O)");
  requests.gallery |= more.add("Examples", "The shipped scenes (F2)");
  requests.export_dialog |= more.add("Export...", "The state of now: .vtu, .csv, .msh or .obj (Ctrl+E)");
  ButtonRow clock(3);
  if (clock.add(state.paused ? "Play" : "Pause", "Space", state.paused)) state.paused = !state.paused;
  requests.step |= clock.add("Step", "One time step (.)");
  requests.reset |= clock.add("Reset", "Back to the start of the scene (R)");
  ButtonRow pictures(3);
  requests.screenshot |= pictures.add("Screenshot", "A PNG in the current folder (P); hide the panels with H to leave them out");
  requests.video |= pictures.add(state.recording ? "Stop video" : "Video", "A video in the current folder (V; Shift+V chooses what it is to be)", state.recording);
  if (pictures.add("Plots", "Curves over time (F3)", state.plots.shown)) state.plots.shown = !state.plots.shown;

  const Model& model = simulation.model;
  const Statistics& clock_now = state.statistics;
  ui::fact("Mesh", grouped(model.rest_positions.size()) + " vertices, " + grouped(model.tets.size()) + " tets");
  ui::fact("Mass", engineering(state.facts.mass(model), "kg"), "At the present densities; lumped to the vertices");
  char text[64];
  if (clock_now.measured)
    std::snprintf(text, sizeof text, "%.2f s at %.0f %% of real time", simulation.time(), state.paused ? 0 : 100 * clock_now.speed);
  else
    std::snprintf(text, sizeof text, "%.2f s", simulation.time());
  ui::fact("Time", text, "Simulated since the start of the scene");
  for (const std::string& note : model.notes) {
    ImGui::PushStyleColor(ImGuiCol_Text, ui::kWarning);
    ImGui::TextWrapped("%s", note.c_str());
    ImGui::PopStyleColor();
  }
}

}  // namespace fascia
