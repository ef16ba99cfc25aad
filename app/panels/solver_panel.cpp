// How the scene is solved: method, effort, time step, gravity and true error.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <type_traits>

#include "app/panels/panels.h"
#include "app/ui/style.h"
#include "app/ui/units.h"
#include "app/ui/widgets.h"
#include "base/text.h"

namespace fascia {
namespace {

struct SolverSlider {
  const char* name;
  const char* label;
  double min, max;
  bool logarithmic;
  const char* zero = "";  // ui::NumberField
};
constexpr SolverSlider kSolverSliders[] = {{"iterations", "Iterations", 1, 200, true},
                                           {"tolerance", "Tolerance", 0, 0.1, true, "off"},
                                           {"time_step", "Time step", 1e-3, 0.1, true},
                                           {"substeps", "Substeps", 1, 30, true},
                                           {"frame_budget", "Frame budget", 0, 50, false, "off"},
                                           {"colors", "Colors", 0, 40, false, "auto"},
                                           {"spectral_radius", "Spectral radius", 0, 0.9999, false, "auto"},
                                           {"window", "Window", 1, 10, false},
                                           {"rest_speed", "Rest speed", 0, 1e-2, true, "off"}};

// Found by overload for both kinds of choice.
constexpr auto kLabelOf = [](auto choice) { return label_of(choice); };
constexpr auto kHelpOf = [](auto choice) { return help_of(choice); };

bool pair_combos(SolverSettings& settings, const Model& model) {
  std::vector<Method> all;
  for (const MethodInfo& info : methods()) all.push_back(info.method);
  bool changed = ui::choice("Method", all, settings.method, kLabelOf, kHelpOf, [&](Method method) {
    return refusal(method, model.materials, model.has_quadratic(), model.has_contact());
  });
  // A new method keeps the current acceleration if it supports it; otherwise, and after none, it gets the best one.
  const bool none = changed && settings.acceleration == Acceleration::none;
  const auto pair = none ? std::nullopt : find_choice(name_of(settings.method), name_of(settings.acceleration));
  settings.acceleration = pair.value_or(*find_choice(name_of(settings.method), {})).acceleration;
  std::vector<Acceleration> accelerations;
  for (const SolverChoice& legal : solver_choices())
    if (legal.method == settings.method) accelerations.push_back(legal.acceleration);
  changed |= ui::choice("Acceleration", accelerations, settings.acceleration, kLabelOf, kHelpOf);
  return changed;
}

void gravity_row(Simulation& simulation) {
  constexpr const char* kHelp = "Acceleration along x, y and z in m/s\xc2\xb2: drag, or double click to type";
  Eigen::Vector3d gravity = simulation.scene.gravity;
  ui::label("Gravity", kHelp);
  const float speed = 0.05f;
  const double least = -100, most = 100;
  ImGui::PushItemWidth(-FLT_MIN);
  if (ImGui::DragScalarN("##gravity", ImGuiDataType_Double, gravity.data(), 3, speed, &least, &most, "%.2f",
                         ImGuiSliderFlags_AlwaysClamp))
    simulation.set_gravity(gravity);
  ImGui::PopItemWidth();
  ui::tooltip(kHelp);
}

// A share as a bar on a logarithmic scale, from 0.001 % to 100 %.
void error_bar(const char* label, double share, const char* help) {
  constexpr double kDecades = 5;
  char percent[32];
  std::snprintf(percent, sizeof percent, "%.2g %%", 100 * share);
  ui::fact(label, percent, help);
  const double length = share > 0 ? std::clamp(1 + std::log10(share) / kDecades, 0.0, 1.0) : 0;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui::px(4);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(corner, {corner.x + width, corner.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg));
  draw.AddRectFilled(corner, {corner.x + static_cast<float>(length) * width, corner.y + height},
                     ImGui::GetColorU32(ImGuiCol_PlotHistogram));
  ImGui::Dummy({width, height});
}

// What the tissue is off by, told apart.
void error_bars(const StepError& error) {
  error_bar("Solver", error.of_displacement,
            "Error of the last step relative to the displacement: more iterations make it smaller");
  if (error.time)
    error_bar(
        error.time->resolved ? "Time step" : "Time step (not resolved)", error.time->relative,
        "Estimated error that the next six steps gather, relative to the displacement: BDF2 or more substeps make "
        "it smaller. Not resolved: it hardly falls with up to eight times the substeps, and the value is a rough "
        "bound");
  error_bar(
      "Mesh", error.mesh,
      "Estimated error of this shape relative to the displacement: a finer mesh or quadratic tets make it smaller");
  constexpr const char* kPeak = "The same error of the recovered von Mises stress that 1 % of the volume exceeds";
  if (error.peak_stress.solver) error_bar("Peak stress: solver", *error.peak_stress.solver, kPeak);
  if (error.time) error_bar("Peak stress: time step", error.time->peak_stress, kPeak);
  error_bar("Peak stress: mesh", error.peak_stress.mesh, kPeak);
}

// The distance to the exact step: requested once or continuously.
void error_row(Session& session) {
  if (session.simulation.uses_reference()) return;
  constexpr const char* kHelp =
      "Distance of the last substep's shape to the exact one, by the reference solver on another thread, in percent of "
      "the distance between the exact shape and the shape that inertia and gravity alone give";
  TrueError& error = session.true_error;
  if (session.simulation.model.tets.size() > TrueError::kMostTets) {
    ui::fact("True error", "mesh too large", kHelp);
    return;
  }
  std::string text = error.busy() ? "measuring ..." : error.requested() ? "waits for a step with motion" : "-";
  if (const auto& result = error.result()) {
    char percent[32];
    std::snprintf(percent, sizeof percent, "%.2g %%", 100 * result->relative);
    text = result->converged ? std::string(percent) + " (" + engineering(result->largest, "m") + ")"
                             : "no exact step found";
  }
  ui::fact("True error", text, kHelp);
  if (ui::button("Measure",
                 "Compares the next step with the exact one, and the next six with shorter ones, on another thread",
                 0.5f * ImGui::GetContentRegionAvail().x))
    error.request();
  ImGui::SameLine();
  ui::checkbox("continuously", session.follow_true_error,
               "One comparison after the other; the thread takes time from a solver that runs on the CPU");
  if (const auto& result = error.result(); result && result->converged) error_bars(*result);
}

}  // namespace

void solver_panel(const PanelContext& context) {
  Session& session = context.session;
  WindowState& state = context.state;
  Simulation& simulation = session.simulation;
  SolverSettings settings = simulation.scene.solver;
  bool changed = false;
  if (simulation.uses_reference())
    ui::fact("Method", "Newton, double precision", "The reference solver on the CPU: exact, slow, and without grabs");
  else
    changed = pair_combos(settings, simulation.model);
  std::vector<Integrator> all;
  for (const IntegratorInfo& info : integrators()) all.push_back(info.integrator);
  changed |= ui::choice("Integrator", all, settings.integrator, kLabelOf, kHelpOf);
  bool better = false;  // its remedy was asked for
  visit_settings(settings, [&](auto& value, const char* name, const char* unit, auto min, auto max, bool logarithmic,
                               const char* help) {
    if (!applies(name, settings.choice())) return;
    using Value = std::remove_reference_t<decltype(value)>;
    ui::NumberField field{
        name, unit, double(min), double(max), double(min), double(max), logarithmic, std::is_same_v<Value, int>, help};
    for (const SolverSlider& extra : kSolverSliders) {
      if (std::strcmp(extra.name, name) != 0) continue;
      field.label = extra.label;
      field.slider_min = extra.min;
      field.slider_max = extra.max;
      field.logarithmic = extra.logarithmic;
      field.zero = extra.zero;
    }
    double number = value;
    const bool turned = ui::number(field, number);
    // Without measured times a large residual cannot be recognised as temporary.
    if (field.label == "Iterations" && state.statistics.measured && !simulation.asleep())
      better |= hint_row(state.hints, iterations_hint(simulation.scene.solver, state.statistics.diagnostics));
    if (field.label == "Time step") hint_row(state.hints, time_step_hint(simulation.scene.solver));
    if (!turned) return;
    value = static_cast<Value>(std::clamp(number, field.min, field.max));
    changed = true;
  });
  if (better) {
    settings.method = solver_choices().front().method;
    settings.acceleration = solver_choices().front().acceleration;
    changed = true;
  }
  if (changed) {
    simulation.set_settings(settings);
    session.true_error.forget();  // it was that of other settings
  }
  if (const Coloring* coloring = simulation.gpu() ? simulation.gpu()->coloring() : nullptr)
    ui::fact("In use",
             plural(coloring->color_count(), "color") + ", " + plural(coloring->phantom_vertex.size(), "phantom"),
             "Each color waits for the one before it; phantoms are copies of vertices that more colors than allowed "
             "would move");
  gravity_row(simulation);
  error_row(session);
}

}  // namespace fascia
