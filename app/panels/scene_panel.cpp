// The top of the column: the open scene, files, and the buttons of the clock.
#include <imgui.h>

#include <cstdio>

#include "app/panels/panels.h"
#include "app/ui/style.h"
#include "app/ui/units.h"
#include "app/ui/widgets.h"

namespace fascia {
namespace {

std::string grouped(std::size_t number) {  // 12345 as 12 345
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, " ");
  return text;
}

}  // namespace

void scene_panel(const PanelContext& context) {
  const Simulation& simulation = context.session.simulation;
  WindowState& state = context.state;
  Requests& requests = context.requests;
  const Scene& scene = simulation.scene;
  ImGui::PushFont(ui::bold_font());
  ImGui::TextWrapped("%s", scene.title.empty() ? scene.file.stem().string().c_str() : scene.title.c_str());
  ImGui::PopFont();
  ui::tooltip(scene.file.string());

  ui::ButtonRow files(3);
  requests.open_dialog |= files.add("Open...", "A scene, a mesh or a replay (Ctrl+O, or drop a file on the window)");
  requests.save_dialog |= files.add("Save...", "This scene with the values of the sliders, as JSON (Ctrl+S)");
  if (files.add("Help", "Keys and mouse (F1)", state.show_help)) state.show_help = !state.show_help;
  ui::ButtonRow more(3);
  requests.recent |= more.add("Recent", "Recent files (Ctrl+Shift+O)");
  requests.gallery |= more.add("Examples", "The shipped scenes (F2)");
  requests.export_dialog |= more.add("Export...", "The current state: .vtu, .csv, .msh or .obj (Ctrl+E)");
  ui::ButtonRow clock(3);
  if (clock.add(state.paused ? "Play" : "Pause", "Space", state.paused)) state.paused = !state.paused;
  requests.step |= clock.add("Step", "One time step (.)");
  requests.reset |= clock.add("Reset", "Back to the start of the scene (R)");
  ui::ButtonRow pictures(3);
  requests.screenshot |=
      pictures.add("Screenshot", "A PNG in the current folder (P); hide the panels with H to leave them out");
  requests.video |= pictures.add(state.recording ? "Stop video" : "Video",
                                 "A video in the current folder (V; Shift+V: video settings)", state.recording);
  if (pictures.add("Plots", "Curves over time (F3)", state.plots.shown)) state.plots.shown = !state.plots.shown;

  const UndoHistory& history = state.history;
  ui::ButtonRow changes(3);
  if (changes.add("Undo", history.can_undo() ? "Undoes: " + history.undone_next().text + " (Ctrl+Z)"
                                             : "Nothing to undo (Ctrl+Z)") &&
      history.can_undo())
    requests.history = history.done() - 1;
  if (changes.add("Redo", history.can_redo() ? "Redoes: " + history.redone_next().text + " (Ctrl+Y)"
                                             : "Nothing to redo (Ctrl+Y)") &&
      history.can_redo())
    requests.history = history.done() + 1;
  if (changes.add("Compare", "Two settings side by side under the same grab (B)", state.comparing))
    requests.compare = CompareAsk::open_or_close;

  const Model& model = simulation.model;
  const Statistics& clock_now = state.statistics;
  ui::fact("Mesh",
           grouped(model.rest_positions.size()) + " vertices, " + grouped(model.tets.size()) +
               (model.tets.size() == 1 ? " tet" : " tets"),
           "Counts of all bodies, as simulated: without degenerate tets");
  ui::fact("Mass", engineering(state.facts.mass(model), "kg"), "At the current densities; lumped to the vertices");
  char text[64];
  if (clock_now.measured)
    std::snprintf(text, sizeof text, "%.2f s at %.0f %% of real time", simulation.time(),
                  state.paused ? 0 : 100 * clock_now.speed);
  else
    std::snprintf(text, sizeof text, "%.2f s", simulation.time());
  ui::fact("Time", text, "Simulated since the start of the scene");
  if (const auto& unit = state.facts.unit; unit && hint_row(state.hints, unit->hint)) requests.rescale = unit->scale;
  for (const std::string& note : model.notes) {
    ImGui::PushStyleColor(ImGuiCol_Text, ui::kWarning);
    ImGui::TextWrapped("%s", note.c_str());
    ImGui::PopStyleColor();
  }
}

}  // namespace fascia
