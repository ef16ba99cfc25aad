// Curves over time: the chosen charts, one above the other.
#include <imgui.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "app/panels/panels.h"
#include "app/panels/time_plot.h"
#include "app/ui/style.h"
#include "app/ui/units.h"
#include "app/ui/widgets.h"

namespace fascia {
namespace {

using ui::TimeChart;
using ui::TimeCurve;

constexpr TimeCurve kEnergy[] = {{"kinetic", [](const Sample& s) { return s.kinetic; }},
                                 {"elastic", [](const Sample& s) { return s.elastic; }},
                                 {"gravity", [](const Sample& s) { return s.gravitational; }},
                                 {"total", [](const Sample& s) { return s.total(); }}};
constexpr TimeCurve kVolume[] = {{"", [](const Sample& s) { return s.volume_ratio; }}};
constexpr TimeCurve kForce[] = {{"grab", [](const Sample& s) { return s.grab.norm(); }},
                                {"supports", [](const Sample& s) { return s.reaction.norm(); }}};
constexpr TimeCurve kDisplacement[] = {{"x", [](const Sample& s) { return s.probe.x(); }},
                                       {"y", [](const Sample& s) { return s.probe.y(); }},
                                       {"z", [](const Sample& s) { return s.probe.z(); }},
                                       {"length", [](const Sample& s) { return s.probe.norm(); }}};
constexpr TimeCurve kResidual[] = {{"", [](const Sample& s) { return s.residual; }}};
constexpr TimeCurve kIterationCurves[] = {{"", [](const Sample& s) { return s.iterations; }}};
constexpr TimeCurve kClock[] = {{"frame", [](const Sample& s) { return s.frame_ms / 1000; }},
                                {"step", [](const Sample& s) { return s.step_ms / 1000; }}};

const TimeChart kCharts[] = {{"Energy", "J", false, kEnergy},   {"Volume", "", false, kVolume},
                             {"Force", "N", false, kForce},     {"Displacement", "m", false, kDisplacement},
                             {"Residual", "", true, kResidual}, {"Iterations", "", false, kIterationCurves},
                             {"Clock", "s", false, kClock}};
const char* const kChartHelp[] = {
    "Kinetic, elastic and gravitational energy (0 at the rest positions) and their sum: damping by the tissue or by "
    "the time step reduces the sum",
    "Volume of all tissue, over its volume at rest",
    "Forces of the mouse and of the supports on the tissue",
    "Displacement of the point marked in the picture: at first the point farthest from the supports",
    "Relative residual of each step: 0 is an exact solution, 1 is the residual of the start",
    "Iterations of each step, per substep",
    "Time from picture to picture, and of one time step on the GPU",
    "The residual over the iterations of the next step"};
static_assert(std::size(kCharts) + 1 == Plots::kCharts && std::size(kChartHelp) == Plots::kCharts);
constexpr std::size_t kConvergence = Plots::kCharts - 1;

void choose_charts(Plots& plots) {
  for (std::size_t i = 0; i < Plots::kCharts; ++i) {
    const char* name = i == kConvergence ? "Convergence" : kCharts[i].title;
    const float width = ImGui::CalcTextSize(name).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (i > 0) {
      ImGui::SameLine(0, ui::px(4));
      if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
    }
    if (ui::button(name, width, plots.chosen[i])) plots.chosen[i] = !plots.chosen[i];
    ui::tooltip(kChartHelp[i]);
  }
}

void buttons(Plots& plots, Requests& requests) {
  const float width = (ImGui::GetContentRegionAvail().x - 4 * ImGui::GetStyle().ItemSpacing.x) / 5;
  if (ui::button(plots.held ? "Go on" : "Hold", width, plots.held)) plots.held = !plots.held;
  ui::tooltip("Holds the curves while the simulation continues");
  ImGui::SameLine();
  if (ui::button("Clear", width)) plots.history.clear();
  ImGui::SameLine();
  if (ui::button("Point", width, plots.choosing)) plots.choosing = !plots.choosing;
  ui::tooltip("Then click on the tissue: the displacement of the vertex next to the click is plotted");
  ImGui::SameLine();
  requests.plot_table |= ui::button("CSV", width);
  ui::tooltip("Writes all quantities over the time shown, with units and provenance, to the current folder");
  ImGui::SameLine();
  requests.plot_picture |= ui::button("PNG", width);
  if (!requests.plot_picture)
    ui::tooltip("Writes a picture of the panel to the current folder");  // a tooltip now would be part of the picture
}

}  // namespace

bool shows_convergence(const Plots& plots) { return plots.shown && plots.chosen[kConvergence]; }

void draw_plots(const Simulation& simulation, WindowState& state, Requests& requests) {
  Plots& plots = state.plots;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float margin = ui::px(10), least_width = ui::px(260), least_height = ui::px(180);
  const float width = std::floor(std::max(least_width, std::min(ui::px(430), 0.45f * screen.x)));
  const std::array<float, 4> dock{screen.x - width - margin, margin, width,
                                  std::max(least_height, screen.y - 2 * margin)};
  const bool dock_moved = std::exchange(plots.dock, dock) != dock;
  if (plots.docked && dock_moved) {
    ImGui::SetNextWindowPos({dock[0], dock[1]});
    ImGui::SetNextWindowSize({dock[2], dock[3]});
  }
  ImGui::SetNextWindowSizeConstraints({least_width, least_height},
                                      {std::max(least_width, screen.x), std::max(least_height, screen.y)});
  const char* title = state.comparing ? "Plots of side A###Plots" : "Plots###Plots";
  if (ImGui::Begin(title, &plots.shown, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing)) {
    ui::keep_inside();
    const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const auto at = [](float is, float wanted) { return std::abs(is - wanted) < 2; };
    plots.docked = at(corner.x, dock[0]) && at(corner.y, dock[1]) && at(size.x, dock[2]) && at(size.y, dock[3]);
    plots.left = corner.x, plots.top = corner.y, plots.width = size.x, plots.height = size.y;
    buttons(plots, requests);
    choose_charts(plots);
    constexpr float kConvergenceHeight = 210;  // [points]
    std::size_t chosen = 0, last = 0, lines = 0;
    for (std::size_t i = 0; i < std::size(kCharts); ++i)
      if (plots.chosen[i]) {
        ++chosen;
        last = i;
        lines += kCharts[i].curves.size() > 2 ? 2 : 1;  // of the legend, at the default width
      }
    const float room =
        ImGui::GetContentRegionAvail().y / ui::px(1) - (plots.chosen[kConvergence] ? kConvergenceHeight : 0);
    const float legends = static_cast<float>(lines) * ImGui::GetTextLineHeightWithSpacing() +
                          static_cast<float>(chosen) * ImGui::GetStyle().ItemSpacing.y;
    const float height =
        std::max(64.0f, (room - legends / ui::px(1)) / static_cast<float>(std::max<std::size_t>(chosen, 1)));
    plots.cursor = std::exchange(plots.cursor_next, std::nullopt);
    for (std::size_t i = 0; i < std::size(kCharts); ++i)
      if (plots.chosen[i]) ui::time_plot(kCharts[i], plots, height, i == last);
    if (plots.chosen[kConvergence]) convergence_rows(simulation, state.convergence);
  }
  ImGui::End();
}

}  // namespace fascia
