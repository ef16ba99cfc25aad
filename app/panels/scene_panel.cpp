// The top of the column, above the tabs: the open scene, the icons, and the size and time of the scene.
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

// The counts of the mesh; while the motion has turned tets inside out, how many, at the same place: rows below stay.
void mesh_row(const Model& model, const Statistics& statistics) {
  if (!statistics.inverted_since)
    return ui::fact("Mesh",
                    grouped(model.rest_positions.size()) + " vertices, " + grouped(model.tets.size()) +
                        (model.tets.size() == 1 ? " tet" : " tets"),
                    "Counts of all bodies, as simulated: without degenerate tets");
  const int count = statistics.diagnostics ? statistics.diagnostics->inverted : 0;
  char text[96];
  std::snprintf(text, sizeof text, "%d %s inside out since %.2f s", count, count == 1 ? "tet" : "tets",
                *statistics.inverted_since);
  ui::fact("Mesh", text,
           "Simulated time at which the first tet turned inside out (J below 0). This goes when all tets are upright "
           "again. Smaller steps, more iterations or a gentler grab avoid it",
           &ui::kWarning);
}

// What the reader of the mesh has changed. It holds for the file, not for the motion, and a click hides it.
void notes_rows(const Model& model, HintBoard& hints) {
  for (const std::string& note : model.notes)
    hint_row(hints,
             Hint{note, note, "Found when the scene was opened: about its files, not about the motion", "", true});
}

// The guesses about a mesh on its own that files do not state: one button settles each otherwise.
void mesh_frame_rows(const BareMeshPlan& plan, Requests& requests) {
  const auto open_again = [&](LengthUnit unit, UpAxis up) {
    std::vector<std::string> sets = plan.overrides;
    sets.push_back(std::string("unit=") + name_of(unit));
    sets.push_back(std::string("up=") + name_of(up));
    requests.open_again = std::move(sets);
  };
  ui::label("Unit", "Of the mesh's coordinates, " + plan.unit_reason + ". A saved scene has it as the key unit");
  ui::ButtonRow units(static_cast<int>(kLengthUnits.size()));
  for (const LengthUnit unit : kLengthUnits) {
    const std::string help = std::string("Opens the mesh again in ") + name_of(unit);
    const char* const label = unit == LengthUnit::um ? "\xc2\xb5m" : name_of(unit);
    const bool lit = unit == plan.unit;
    if (units.add(label, help, lit) && !lit) open_again(unit, plan.up);
  }
  ui::label("Up", "Axis of the mesh that points up: " + plan.up_reason + ". A saved scene has it as the key up");
  ui::ButtonRow axes(static_cast<int>(kUpAxes.size()));
  for (const UpAxis up : kUpAxes) {
    const std::string help = std::string("Opens the mesh again with ") + name_of(up) + " up";
    const bool lit = up == plan.up;
    if (axes.add(name_of(up), help, lit) && !lit) open_again(plan.unit, up);
  }
}

}  // namespace

void scene_panel(const PanelContext& context) {
  const Simulation& simulation = context.session.simulation;
  WindowState& state = context.state;
  const Scene& scene = simulation.scene;
  ImGui::PushFont(ui::bold_font());
  ImGui::TextWrapped("%s", scene.title.empty() ? scene.file.stem().string().c_str() : scene.title.c_str());
  ImGui::PopFont();
  ui::tooltip(scene.file.string());

  toolbar(context);

  const Model& model = simulation.model;
  const Statistics& clock_now = state.statistics;
  mesh_row(model, state.statistics);
  ui::fact("Mass", engineering(state.facts.mass(model), "kg"), "At the current densities; lumped to the vertices");
  char text[64];
  if (clock_now.measured && !state.recording)  // a video has a speed of its own
    std::snprintf(text, sizeof text, "%.2f s at %.0f %% of real time", simulation.time(),
                  state.paused ? 0 : 100 * clock_now.speed);
  else
    std::snprintf(text, sizeof text, "%.2f s", simulation.time());
  ui::fact("Time", text, "Simulated since the start of the scene");
  if (const auto& unit = state.facts.unit; unit && hint_row(state.hints, unit->hint))
    context.requests.rescale = unit->scale;
  if (model.plan) mesh_frame_rows(*model.plan, context.requests);
  notes_rows(model, state.hints);
}

}  // namespace fascia
