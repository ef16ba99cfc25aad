// The brush of the mouse: fixes and releases vertices, and paints tets into regions.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "app/panels/panels.h"
#include "app/ui/units.h"
#include "app/ui/widgets.h"
#include "sim/material/tissues.h"

namespace fascia {
namespace {

const char* const kRegionHelp =
    "The region that is painted: one of the mesh, one that was painted before, or a new one. The panel Material has "
    "its "
    "values; Color: region, on the tab Display, shows all regions";

void brush_buttons(BrushSettings& settings) {
  ui::ButtonRow tools(4);
  const auto tool = [&](const char* name, const char* help, Brush brush) {
    if (!tools.add(name, help, settings.brush == brush)) return;
    settings.brush = settings.brush == brush ? Brush::off : brush;
    settings.reveal = true;
  };
  tool(
      "Fix",
      "Brush over the tissue: vertices within the ring are fixed when the button is released. [ and ], or Ctrl and the "
      "wheel, change its size. Esc puts the brush away; Shift + left still grabs",
      Brush::fix);
  tool("Release", "Brush over the tissue: fixed vertices within the ring are free when the button is released",
       Brush::release);
  tool("Paint",
       "Brush over the tissue: tets within a ball of the ring's size belong to the region below when the button is "
       "released. A section plane gives access to the inside",
       Brush::paint);
  tool("Erase", "Brush over the tissue: painted tets belong to the region of the mesh file again", Brush::erase);
}

void region_combo(const SceneFacts& facts, BrushSettings& settings) {
  ui::label("Region", kRegionHelp);
  if (!ImGui::BeginCombo("##region", settings.region.empty() ? "New region" : settings.region.c_str())) {
    ui::tooltip(kRegionHelp);
    return;
  }
  if (ImGui::Selectable("New region", settings.region.empty())) settings.region.clear();
  std::vector<std::string> keys;  // bodies may share some
  for (const SceneFacts::Region& region : facts.regions) keys.push_back(region.key);
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  for (const std::string& key : keys)
    if (ImGui::Selectable(key.c_str(), key == settings.region)) settings.region = key;
  ImGui::EndCombo();
}

void new_region(BrushSettings& settings) {
  ui::label("Name", "Name of the new region, under which the scene saves its tets and its material");
  ImGui::InputText("##name", &settings.new_name);
  std::vector<const Tissue*> choices = {nullptr};
  for (const Tissue& tissue : tissues()) choices.push_back(&tissue);
  ui::choice(
      "Tissue", choices, settings.tissue, [](const Tissue* tissue) { return tissue ? tissue->label : "as around it"; },
      [](const Tissue* tissue) {
        return tissue ? about(*tissue) : std::string("The new region starts with the default material");
      });
}

}  // namespace

void brush_panel(const PanelContext& context) {
  const Simulation& simulation = context.session.simulation;
  WindowState& state = context.state;
  BrushSettings& settings = state.brush;
  ui::fact("Fixed vertices", std::to_string(simulation.model.fixed.size()),
           "They stay where they are at rest: the black dots");
  if (state.comparing || simulation.uses_reference()) settings.brush = Brush::off;
  ImGui::BeginDisabled(state.comparing || simulation.uses_reference());
  brush_buttons(settings);
  ui::checkbox("Lasso", settings.lasso,
               "Draw a closed curve instead: Fix and Release take the visible vertices of the surface within it, Paint "
               "and Erase the tets");
  if (settings.of_tets() && settings.lasso) {
    ImGui::SameLine();
    ui::checkbox("through", settings.through, "Takes all tets within the curve, as deep as the tissue is");
    const double size = context.session.look.radius;
    double depth = settings.depth * size;
    if (!settings.through &&
        ui::number({"Depth", "m", 0, size, 0, 10 * size, false, false,
                    "How far behind the visible tissue the lasso takes tets; with 0 the layer at the surface"},
                   depth))
      settings.depth = depth / size;
  }
  if (settings.brush == Brush::paint) {
    region_combo(state.facts, settings);
    if (settings.region.empty()) new_region(settings);
  }
  ImGui::EndDisabled();
  if (std::exchange(settings.reveal, false) && settings.in_hand()) ImGui::SetScrollHereY(1);
}

}  // namespace fascia
