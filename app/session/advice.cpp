#include "app/session/advice.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/ui/style.h"
#include "app/ui/units.h"
#include "app/ui/widgets.h"
#include "sim/mesh/mesh_check.h"

namespace fascia {

std::optional<Hint> locking_hint(double poisson_ratio, bool remedy) {
  if (poisson_ratio <= kLockingPoissonRatio) return std::nullopt;
  return Hint{
      "locking", "Linear tets lock above 0.45: too stiff.",
      std::string("A linear tet has one strain, and near 0.5 nearly no way to bend without changing its volume: "
                  "the body moves too little, the coarser the mesh the worse. ") +
          (remedy ? "Quadratic elements on the same mesh do not lock. They have up to eight times the vertices, "
                    "so a step takes up to eight times as long; Undo goes back. "
                  : "The method two_level has quadratic elements, which do not lock. ") +
          "Or take 0.45, or a finer mesh, and more iterations: 0.49 needs about three times as many.",
      remedy ? "Quadratic elements" : ""};
}

std::optional<UnitHint> unit_hint(const Scene& scene, const Model& model) {
  if (model.tets.empty() || model.plan) return std::nullopt;  // a plan has a unit
  Eigen::AlignedBox3d box;
  for (const Tet& tet : model.tets)
    for (const std::uint32_t v : tet) box.extend(model.rest_positions[v]);
  const double extent = box.sizes().maxCoeff();
  const std::string advice = guess_unit(extent, scene.bodies.front().transform.scale);
  const double scale = scale_to_meters(extent);
  if (advice.empty() || scale == 1) return std::nullopt;
  const std::string unit = scale == 1e-3   ? "millimeters"
                           : scale == 1e-2 ? "centimeters"
                           : scale == 1e-6 ? "micrometers"
                                           : "another unit";
  return UnitHint{{"unit", engineering(extent, "m") + " wide: made in " + unit + "?", advice,
                   "Scale to " + engineering(scale * extent, "m")},
                  scale};
}

std::optional<Hint> iterations_hint(const SolverSettings& settings, const std::optional<Diagnostics>& diagnostics) {
  // A residual of a tenth of the step is where the error becomes visible.
  constexpr double kVisible = 0.1;
  if (!diagnostics || !std::isfinite(diagnostics->residual) || diagnostics->residual < kVisible) return std::nullopt;
  const Method best = solver_choices().front().method;
  const bool stays_soft = settings.method == Method::jacobi;
  char text[64];
  std::snprintf(text, sizeof text,
                stays_soft ? "Residual %.2g: this method stays too soft." : "Residual %.2g: too few iterations?",
                diagnostics->residual);
  std::string help =
      "The last step was left unsolved by this share, so the tissue acts softer or slower than its material is. ";
  if (stays_soft)
    help += "More iterations of averaged Jacobi do not reach the material's stiffness; another method does.";
  else
    help += "More iterations, shorter steps or more substeps help.";
  help += " At rest, and in the first steps of a grab, a large share of nearly nothing means little.";
  const std::string remedy = settings.method == best ? "" : std::string("Use ") + label_of(best);
  return Hint{"iterations", text, help, remedy};
}

std::optional<Hint> time_step_hint(const SolverSettings& settings) {
  constexpr double kLongest = 1.0 / 29;  // [s]
  if (settings.integrator != Integrator::implicit_euler || settings.substep() < kLongest) return std::nullopt;
  return Hint{
      "time step", "Long steps damp motion strongly.",
      "Implicit Euler takes energy out of every motion that is not much longer than a substep: tissue swings "
      "less and settles sooner than it would. Shorter steps, more substeps or another integrator keep the motion.",
      ""};
}

bool hint_row(HintBoard& board, const std::optional<Hint>& hint) {
  if (!hint || board.dismissed.count(hint->name)) return false;
  ImGui::PushID(hint->name.c_str());
  const float end = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x,
              button = ImGui::GetFontSize() + ui::px(4);
  ImGui::BeginGroup();
  ImGui::PushStyleColor(ImGuiCol_Text, hint->quiet ? ui::kDim : ui::kWarning);
  ImGui::PushTextWrapPos(end - button - ui::px(4));
  ImGui::TextUnformatted(hint->text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::EndGroup();
  ui::tooltip(hint->help);
  ImGui::SameLine(end - button);
  if (ui::small_button("x", "Not again in this window", button)) board.dismissed.insert(hint->name);
  const bool asked = !hint->remedy.empty() && ui::small_button(hint->remedy.c_str(), hint->help);
  ImGui::PopID();
  return asked;
}

}  // namespace fascia
