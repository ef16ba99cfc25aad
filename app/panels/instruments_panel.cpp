// The instruments of the scene, what they feel, and others to add.
#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/panels/panels.h"
#include "app/ui/style.h"
#include "app/ui/units.h"
#include "app/ui/widgets.h"
#include "base/text.h"

namespace fascia {
namespace {

std::string components(const Eigen::Vector3d& v, const char* unit) {
  return engineering(v.x(), unit) + ", " + engineering(v.y(), unit) + ", " + engineering(v.z(), unit);
}

void load_rows(const std::optional<ToolLoad>& load) {
  const std::string mean = "\nMean of the last " + std::to_string(ToolReadings::kMean) +
                           " readings, one a frame; histories and the CSV of the plots have every one as it is";
  const auto row = [&](const char* name, const std::string& value, const std::string& help) {
    ui::fact(name, load ? value : "-", help);
  };
  const ToolLoad l = load.value_or(ToolLoad());
  row("Force", engineering(l.force.norm(), "N"), "On the tissue, x, y and z: " + components(l.force, "N") + mean);
  row("Normal", engineering(l.normal, "N"),
      "Sum of the normal forces of all points, whatever their directions. Of jaws that hold tissue, twice their grip" +
          mean);
  row("Torque", engineering(l.torque.norm(), "Nm"),
      "Of that force about the origin of the instrument, x, y and z: " + components(l.torque, "Nm") + mean);
  row("Deepest", engineering(l.deepest, "m"),
      "How deep tissue lies within the instrument: 0 where it lies at its surface");
  row("Points", std::to_string(l.points), "Contact points on the surface of the tissue that the instrument presses");
}

void hand_rows(const Tool& tool, std::size_t index, const InstrumentState& state, Requests& requests) {
  ui::fact(
      "Gap", engineering(state.gap, "m") + (state.waits ? ", tissue is crushed" : ""),
      "Way of its farthest point to the place that the hand commands. Near tissue an instrument moves by at most a "
      "quarter of its finest radius in a step, so that it touches what it meets. It does not press on tissue that is "
      "crushed to 0.15 of its thickness: it goes along it, or waits",
      state.waits ? &ui::kWarning : nullptr);
  if (tool.has_jaws) {
    ui::ButtonRow jaws(2);
    const auto add = [&](const char* text, double grip, const char* help) {
      jaws.add(text, help);
      if (ImGui::IsItemActivated()) requests.move_jaws = grip;
      requests.stop_jaws |= ImGui::IsItemDeactivated();
    };
    add("Close (G)", 1, "Closes the jaws while it is held down, and they stay where it is released");
    add("Open (Shift + G)", 0, "Opens the jaws while it is held down, and they stay where it is released");
  }
  ui::ButtonRow buttons(2);
  requests.let_go_instrument |=
      buttons.add("Let go (Esc)", "The instrument stays where it is, and the mouse grabs again");
  if (buttons.add("Remove", "Takes it out of the scene. Builds the solver anew; Ctrl+Z brings it back"))
    requests.remove_instrument = index;
}

void pair_rows(const Model& model, const std::vector<PairLoad>& loads) {
  for (const PairLoad& load : loads) {
    const auto& [a, b] = load.bodies;
    if (load.pairs == 0) continue;
    const std::string &first = model.bodies[a].name, &second = model.bodies[b].name;
    const std::string on_second = "; their sum with friction on " + second +
                                  ", x, y and z: " + components(load.force, "N") + ", and as much on " + first +
                                  " the other way";
    ui::fact((first + (a == b ? ", itself" : ", " + second)).c_str(), engineering(load.normal, "N"),
             "Normal forces of tissue on tissue in the last step, whatever their directions, at " +
                 plural(load.pairs, "place") + (a == b ? "" : on_second));
  }
}

}  // namespace

void instruments_panel(const PanelContext& context) {
  const Simulation& simulation = context.session.simulation;
  const InstrumentState& state = context.state.instruments;
  Requests& requests = context.requests;
  const std::vector<Tool>& tools = simulation.model.tools;
  const std::vector<ToolLoad> loads = state.readings.mean();
  const std::size_t first = tools.size() - simulation.scene.tools.instruments.size();
  for (std::size_t t = first; t < tools.size(); ++t) {
    ImGui::PushID(static_cast<int>(t));
    const bool picked = state.picked == t;
    if (ui::button(tools[t].name.c_str(), ImGui::GetContentRegionAvail().x, picked)) {
      if (picked)
        requests.let_go_instrument = true;
      else
        requests.pick_instrument = t;
    }
    ui::tooltip("Takes it in hand (Tab): left drag moves it, right drag turns it, the wheel moves it away and closer");
    load_rows(t < loads.size() ? std::optional(loads[t]) : std::nullopt);
    if (picked) hand_rows(tools[t], t - first, state, requests);
    ImGui::Spacing();
    ImGui::PopID();
  }
  for (std::size_t t = 0; t < std::min(first, loads.size()); ++t)
    ui::fact(tools[t].name.c_str(), engineering(loads[t].force.norm(), "N"),
             "Force on the tissue, x, y and z: " + components(loads[t].force, "N"));
  if (const auto& d = context.state.statistics.diagnostics) pair_rows(simulation.model, d->pair_loads);
  if (!ui::section("Add")) return;
  constexpr std::size_t kInRow = 2;
  for (std::size_t i = 0; i < kInstrumentPresets.size(); i += kInRow) {
    ui::ButtonRow row(kInRow);
    for (std::size_t k = i; k < std::min(i + kInRow, kInstrumentPresets.size()); ++k) {
      const InstrumentPresetInfo& preset = kInstrumentPresets[k];
      if (row.add(preset.label, std::string(preset.help) + ". Builds the solver anew; Ctrl+Z takes it away again"))
        requests.add_instrument = preset.preset;
    }
  }
}

}  // namespace fascia
