// Fits values with sliders to the measured curve of the plots: the free values, the fit in the background, its result.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/panels.h"
#include "app/ui/field_labels.h"
#include "app/ui/style.h"
#include "app/ui/units.h"
#include "app/ui/widgets.h"
#include "sim/fit/free_values.h"

namespace fascia {
namespace {

// "Young's modulus"; with several materials "Young's modulus, liver: tumour".
std::string label_of(const FreeValue& value, const std::vector<FreeValue>& all) {
  return label_of_field(value.field) + (all.front().material == all.back().material ? "" : ", " + value.material);
}

void choose_values(const std::vector<FreeValue>& values, FitPanel& fit) {
  if (!ImGui::BeginPopup("free values")) return;
  for (const FreeValue& value : values) {
    const auto at = std::find(fit.keys.begin(), fit.keys.end(), value.key);
    bool chosen = at != fit.keys.end();
    if (!ui::checkbox(label_of(value, values).c_str(), chosen, "--free " + value.key)) continue;
    if (chosen)
      fit.keys.push_back(value.key);
    else
      fit.keys.erase(at);
  }
  ImGui::EndPopup();
}

std::string text_of(const Estimate& found, const std::vector<FreeValue>& values) {
  const auto at = std::find_if(values.begin(), values.end(), [&](const FreeValue& v) { return v.key == found.key; });
  const std::string unit = at == values.end() ? "" : at->unit;
  const auto shown = [&](double value) { return engineering(value, unit, 4); };
  const std::string name = at == values.end() ? found.key : label_of(*at, values);
  return name + ": " + shown(found.value) +
         (std::isnan(found.low) ? "" : ", 95 %: " + shown(found.low) + " to " + shown(found.high));
}

}  // namespace

void fit_rows(const Simulation& simulation, FitPanel& fit, Requests& requests) {
  const std::vector<FreeValue> values = free_values(simulation.scene, simulation.model);
  ImGui::PushID("fit");
  ui::ButtonRow row(3);
  const std::string count = "Free values: " + std::to_string(fit.keys.size());
  if (row.add(count.c_str(), "The values that the fit finds; it begins at those of the sliders"))
    ImGui::OpenPopup("free values");
  choose_values(values, fit);
  if (row.add("Equilibria",
              "Fits static equilibria at the times of the curve: a slow test. Else it is a motion from the start",
              fit.equilibria))
    fit.equilibria = !fit.equilibria;
  if (fit.running)
    requests.end_fit |= row.add("Cancel", "Ends the fit; the scene stays as it is");
  else if (row.add("Fit",
                   "Finds the free values with which the simulation meets the measured curve, in the background"))
    requests.fit = true;
  if (!fit.line.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, fit.failed ? ui::kDanger : ui::kDim);
    ImGui::TextWrapped("%s", fit.line.c_str());
    ImGui::PopStyleColor();
  }
  for (const Estimate& found : fit.found) ImGui::TextWrapped("%s", text_of(found, values).c_str());
  if (!fit.found.empty()) {
    ui::ButtonRow apply(2);
    requests.apply_fit |= apply.add("Apply", "Sets the sliders to these values; Ctrl+Z undoes it");
    if (apply.add("Discard", "Forgets these values")) fit.found.clear();
  }
  ImGui::PopID();
}

}  // namespace fascia
