// How the iterations of a step converge: the residual over the iterations, for the settings in use and for those pinned
// beside them.
#include <imgui.h>

#include <cstdio>

#include "app/panels/panels.h"
#include "app/ui/log_plot.h"
#include "app/ui/style.h"
#include "app/ui/widgets.h"

namespace fascia {
namespace {

constexpr float kHeight = 130;  // of the chart [points]

// A patch of the line's color, its name, its last residual and a button that removes the line. Returns true if the
// button was pressed.
bool line_row(const Convergence::Line& line, std::size_t index) {
  ImGui::PushID(static_cast<int>(index));
  const float size = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled({corner.x, corner.y + 0.2f * size},
                                            {corner.x + 0.6f * size, corner.y + 0.8f * size}, ui::curve_color(index));
  ImGui::Dummy({0.6f * size, size});
  ImGui::SameLine();
  char end[32] = "";
  if (line.diverged)
    std::snprintf(end, sizeof end, "diverges");
  else if (!line.residuals.empty())
    std::snprintf(end, sizeof end, "%.2g", static_cast<double>(line.residuals.back()));
  bool removed = false;
  if (index > 0) {
    removed = ImGui::SmallButton("x");
    ui::tooltip("Remove this line");
    ImGui::SameLine();
  }
  ui::fact(line.name.c_str(), end,
           index == 0 ? "The settings in use, on the step that comes next"
                      : "Pinned: solves the same step with its own method");
  ImGui::PopID();
  return removed;
}

}  // namespace

void convergence_panel(const PanelContext& context) {
  context.state.show_convergence = true;
  convergence_rows(context.session.simulation, context.state.convergence);
}

void convergence_rows(const Simulation& simulation, Convergence& convergence) {
  if (simulation.uses_reference()) {
    ImGui::TextWrapped("The reference solver solves every step to rounding.");
    return;
  }
  const std::vector<Convergence::Line> lines = convergence.lines();
  std::vector<ui::Curve> curves;
  for (std::size_t i = 0; i < lines.size(); ++i) curves.push_back({ui::curve_color(i), &lines[i].residuals});
  ui::log_plot("##residuals", curves, kHeight);
  std::size_t removed = 0;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (line_row(lines[i], i)) removed = i;
  if (removed > 0) convergence.unpin(removed);
  const SolverSettings& settings = simulation.scene.solver;
  if (convergence.can_pin(settings)) {
    if (ui::button("Pin these settings", ImGui::GetContentRegionAvail().x)) convergence.pin(settings);
    ui::tooltip(
        "Keeps the method and acceleration in use as a line, to compare others with. Each line solves its own "
        "step, one line per frame in turn");
  }
}

}  // namespace fascia
