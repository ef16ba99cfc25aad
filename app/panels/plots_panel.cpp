// Curves over time: the chosen charts, one above the other.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/panels/panels.h"
#include "app/panels/time_plot.h"
#include "app/ui/style.h"
#include "app/ui/units.h"
#include "app/ui/widgets.h"

namespace fascia {
namespace {

using ui::TimeChart;
using ui::TimeCurve;

constexpr float kMargin = 10, kWidth = 430, kLeastWidth = 260, kLeastHeight = 180;  // of the window [points]
constexpr float kTissueWidth = 400;    // left for the tissue where the plots are beside it [points]
constexpr float kBottomShare = 0.42f;  // of the picture's height, where they are below it
constexpr float kFlat = 320,
                kTwoColumns = 560;  // a lower window folds the choice of charts; a wider one has two columns [points]

std::vector<TimeCurve> of_tools(const std::vector<Tool>& tools, Eigen::Vector3d ToolLoad::*quantity) {
  std::vector<TimeCurve> curves;
  for (std::size_t t = 0; t < tools.size(); ++t)
    curves.push_back({tools[t].name, [t, quantity](const Sample& s) {
                        return t < s.tools.size() ? (s.tools[t].*quantity).norm() : Sample::kUnknown;
                      }});
  return curves;
}

// And between the bodies that pressed each other in the time shown.
std::vector<TimeCurve> of_contact(const Model& model, std::span<const Sample> samples) {
  std::vector<TimeCurve> curves = of_tools(model.tools, &ToolLoad::force);
  for (const auto& bodies : touching_bodies(model)) {
    const auto pressed = [&](const Sample& s) { return load_between(s.pairs, bodies).pairs > 0; };
    if (std::none_of(samples.begin(), samples.end(), pressed)) continue;
    const auto& [a, b] = bodies;
    curves.push_back({model.bodies[a].name + (a == b ? ", itself" : ", " + model.bodies[b].name),
                      [bodies](const Sample& s) { return load_between(s.pairs, bodies).normal; }});
  }
  return curves;
}

// All but the last one, Convergence, which is not over time. Contact and Torque are without curves where nothing can
// touch.
std::vector<TimeChart> charts_of(const Model& model, std::span<const Sample> samples) {
  return {{"Energy",
           "J",
           false,
           {{"kinetic", [](const Sample& s) { return s.kinetic; }},
            {"elastic", [](const Sample& s) { return s.elastic; }},
            {"gravity", [](const Sample& s) { return s.gravitational; }},
            {"total", [](const Sample& s) { return s.total(); }}}},
          {"Volume", "", false, {{"", [](const Sample& s) { return s.volume_ratio; }}}},
          {"Force",
           "N",
           false,
           {{"grab", [](const Sample& s) { return s.grab.norm(); }},
            {"supports", [](const Sample& s) { return s.reaction.norm(); }}}},
          {"Contact", "N", false, of_contact(model, samples)},
          {"Displacement",
           "m",
           false,
           {{"x", [](const Sample& s) { return s.probe.x(); }},
            {"y", [](const Sample& s) { return s.probe.y(); }},
            {"z", [](const Sample& s) { return s.probe.z(); }},
            {"length", [](const Sample& s) { return s.probe.norm(); }}}},
          {"Torque", "Nm", false, of_tools(model.tools, &ToolLoad::torque)},
          {"Residual", "", true, {{"", [](const Sample& s) { return s.residual; }}}},
          {"Iterations", "", false, {{"", [](const Sample& s) { return s.iterations; }}}},
          {"Clock",
           "s",
           false,
           {{"frame", [](const Sample& s) { return s.frame_ms / 1000; }},
            {"step", [](const Sample& s) { return s.step_ms / 1000; }}}}};
}

const char* const kChartHelp[] = {
    "Kinetic, elastic and gravitational energy (0 at the rest positions) and their sum: damping by the tissue or by "
    "the time step reduces the sum",
    "Volume of all tissue, over its volume at rest",
    "Forces of the mouse and of the supports on the tissue",
    "Force of each instrument, of obstacles and of the ground on the tissue, and the normal forces of bodies on each "
    "other, of single steps",
    "Displacement of the point marked in the picture: at first the point farthest from the supports",
    "Torque of these forces about the origin of each",
    "Relative residual of each step: 0 is an exact solution, 1 is the residual of the start",
    "Iterations of each step, per substep",
    "Time from picture to picture, and of one time step on the GPU",
    "The residual over the iterations of the next step"};
static_assert(std::size(kChartHelp) == Plots::kCharts);
constexpr std::size_t kConvergence = Plots::kCharts - 1;

const char* name_of_chart(const std::vector<TimeChart>& charts, std::size_t i) {
  return i == kConvergence ? "Convergence" : charts[i].title;
}

bool can_be_shown(const std::vector<TimeChart>& charts, std::size_t i) {
  return i == kConvergence || !charts[i].curves.empty();
}

// A button each, or with `folded` a list behind one button.
void choose_charts(const std::vector<TimeChart>& charts, Plots& plots, bool folded) {
  if (folded) {
    ImGui::SameLine();
    if (ui::button("Charts", ImGui::GetContentRegionAvail().x)) ImGui::OpenPopup("charts");
    ui::tooltip("The charts that are shown");
    if (!ImGui::BeginPopup("charts")) return;
    for (std::size_t i = 0; i < Plots::kCharts; ++i)
      if (can_be_shown(charts, i)) ui::checkbox(name_of_chart(charts, i), plots.chosen[i], kChartHelp[i]);
    return ImGui::EndPopup();
  }
  for (std::size_t i = 0; i < Plots::kCharts; ++i) {
    if (!can_be_shown(charts, i)) continue;
    const char* name = name_of_chart(charts, i);
    const float width = ImGui::CalcTextSize(name).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (i > 0) {
      ImGui::SameLine(0, ui::px(4));
      if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
    }
    if (ui::button(name, width, plots.chosen[i])) plots.chosen[i] = !plots.chosen[i];
    ui::tooltip(kChartHelp[i]);
  }
}

// In a row of `count`.
void buttons(Plots& plots, Requests& requests, int count) {
  const float width =
      (ImGui::GetContentRegionAvail().x - static_cast<float>(count - 1) * ImGui::GetStyle().ItemSpacing.x) /
      static_cast<float>(count);
  if (ui::button(plots.held ? "Go on" : "Hold", width, plots.held)) plots.held = !plots.held;
  ui::tooltip("Holds the curves while the simulation continues");
  ImGui::SameLine();
  if (ui::button("Clear", width)) {
    plots.clear();
    requests.end_fit = true;
  }
  ui::tooltip("Removes the curves, measured ones too");
  ImGui::SameLine();
  if (ui::button("Point", width, plots.choosing)) plots.choosing = !plots.choosing;
  ui::tooltip("Then click on the tissue: the displacement of the vertex next to the click is plotted");
  ImGui::SameLine();
  requests.plot_table |= ui::button("CSV", width);
  ui::tooltip("Writes all quantities over the time shown, with units and provenance, to the current folder");
  ImGui::SameLine();
  requests.plot_picture |= ui::button("PNG", width);
  if (!requests.plot_picture)
    ui::tooltip("Writes a picture of the charts to the current folder");  // a tooltip now would be part of the picture
}

// The area of the plots until they are moved: beside the tissue, or below it where the picture is too narrow for both.
std::array<float, 4> dock_of(const WindowState& state) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float margin = ui::px(kMargin), left = state.show_panels ? panel_space() : 0,
              bottom = screen.y - margin - state.gallery_height, beside = ui::px(kWidth);
  if (screen.x - left - beside - 2 * margin >= ui::px(kTissueWidth))
    return {screen.x - beside - margin, margin, beside, std::max(ui::px(kLeastHeight), bottom - margin)};
  const float width = std::floor(std::max(ui::px(kLeastWidth), screen.x - left - (left > 0 ? 1 : 2) * margin)),
              height = std::floor(std::max(ui::px(kLeastHeight), kBottomShare * screen.y));
  return {screen.x - width - margin, bottom - height, width, height};
}

// The chosen charts, as high as the room allows.
void draw_charts(const std::vector<TimeChart>& charts, Plots& plots, int columns) {
  constexpr float kConvergenceHeight = 210;  // [points]
  std::vector<std::size_t> chosen;
  std::size_t lines = 0;  // of the legends, at the default width
  for (std::size_t i = 0; i < charts.size(); ++i)
    if (plots.chosen[i] && can_be_shown(charts, i)) {
      chosen.push_back(i);
      lines += charts[i].curves.size() > 2 ? 2 : 1;
    }
  plots.cursor = std::exchange(plots.cursor_next, std::nullopt);
  if (chosen.empty()) return;
  const auto count = chosen.size(), width = static_cast<std::size_t>(columns), rows = (count + width - 1) / width;
  const float room =
      ImGui::GetContentRegionAvail().y / ui::px(1) - (plots.chosen[kConvergence] ? kConvergenceHeight : 0);
  const float legends = static_cast<float>(columns == 1 ? lines : 2 * rows) * ImGui::GetTextLineHeightWithSpacing() +
                        static_cast<float>(rows) * ImGui::GetStyle().ItemSpacing.y;
  const float height = std::max(64.0f, (room - legends / ui::px(1)) / static_cast<float>(rows));
  if (!ImGui::BeginTable("charts", columns)) return;
  for (std::size_t i = 0; i < count; ++i) {
    ImGui::TableNextColumn();
    ui::time_plot(charts[chosen[i]], plots, height, i + width >= count);
  }
  ImGui::EndTable();
}

}  // namespace

bool shows_convergence(const Plots& plots) { return plots.shown && plots.chosen[kConvergence]; }

void draw_plots(const Simulation& simulation, WindowState& state, Requests& requests) {
  Plots& plots = state.plots;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const std::array<float, 4> dock = dock_of(state);
  plots.at_bottom = dock[1] > ui::px(kMargin);
  const bool dock_moved = std::exchange(plots.dock, dock) != dock;
  if (plots.docked && dock_moved) {
    ImGui::SetNextWindowPos({dock[0], dock[1]});
    ImGui::SetNextWindowSize({dock[2], dock[3]});
  }
  const float least_width = ui::px(kLeastWidth), least_height = ui::px(kLeastHeight);
  ImGui::SetNextWindowSizeConstraints({least_width, least_height},
                                      {std::max(least_width, screen.x), std::max(least_height, screen.y)});
  const char* title = state.comparing ? "Plots of side A###Plots" : "Plots###Plots";
  if (ImGui::Begin(title, &plots.shown, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing)) {
    ui::keep_inside();
    const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const auto at = [](float is, float wanted) { return std::abs(is - wanted) < 2; };
    plots.docked = at(corner.x, dock[0]) && at(corner.y, dock[1]) && at(size.x, dock[2]) && at(size.y, dock[3]);
    plots.left = corner.x, plots.top = corner.y, plots.width = size.x, plots.height = size.y;
    const bool flat = size.y < ui::px(kFlat);
    buttons(plots, requests, flat ? 6 : 5);
    const std::vector<TimeChart> charts =
        charts_of(simulation.model, plots.history.between(plots.right_edge() - plots.span, plots.right_edge()));
    choose_charts(charts, plots, flat);
    if (!plots.measured.empty() && !state.comparing) fit_rows(simulation, plots.fit, requests);
    plots.charts_top = ImGui::GetCursorScreenPos().y - 0.5f * ImGui::GetStyle().ItemSpacing.y;
    draw_charts(charts, plots, size.x > ui::px(kTwoColumns) ? 2 : 1);
    if (plots.chosen[kConvergence]) convergence_rows(simulation, state.convergence);
  }
  ImGui::End();
}

}  // namespace fascia
