// How grabs hold the tissue, and the balance of the forces on the body.
#include <imgui.h>

#include <cstdio>

#include "app/panels/panels.h"
#include "app/ui/style.h"
#include "app/ui/units.h"
#include "app/ui/widgets.h"

namespace fascia {
namespace {

constexpr double kBalanced = 0.01, kAlmost = 0.1;  // largest imbalance of a green badge, of an amber one

std::string in_newtons(const Eigen::Vector3d& force) {
  return engineering(force.norm(), "N") + "  (" + engineering(force.x(), "N") + ", " + engineering(force.y(), "N") +
         ", " + engineering(force.z(), "N") + ")";
}

}  // namespace

void grab_panel(const PanelContext& context) {
  WindowState& state = context.state;
  Requests& requests = context.requests;
  const double size = context.session.look.radius;
  double radius = state.grab.radius * size;
  if (ui::number({"Radius", "m", 0.01 * size, 0.4 * size, 0.001 * size, size, true, false,
                  "Radius of the patch that a grab holds: the ring on the tissue under the mouse. [ and ], or Ctrl and "
                  "the wheel"},
                 radius))
    state.grab.radius = radius / size;
  ui::number({"Grip", "", 0.3, 30, 1e-3, 1e3, true, false,
              "Stiffness of a grab's springs relative to the tissue: a higher value follows the mouse more closely and "
              "pulls harder"},
             state.grab.grip);
  ImGui::Checkbox("Push (X)", &state.grab.push);
  ui::tooltip("A press pushes into the surface, the wheel pushes deeper; Alt reverses the setting for one press");
  ImGui::SameLine(0, ui::px(14));
  ImGui::Checkbox("Stay (Ctrl)", &state.grab.stay);
  ui::tooltip(
      "Grabs stay where they are released, as with Ctrl or T; a left click on the mark takes a grab up, a right click "
      "or Delete releases it");
  if (state.grabs == 0) return;
  requests.let_go |=
      ui::button(("Let go of " + std::to_string(state.grabs) + (state.grabs == 1 ? " grab" : " grabs")).c_str(),
                 ImGui::GetContentRegionAvail().x);
  ui::tooltip("Releases all grabs that stay (Esc)");
}

void balance_rows(const Simulation& simulation, const SceneFacts& facts, const Diagnostics& d) {
  ui::fact("Reaction", engineering(d.reaction.norm(), "N"),
           "Force of the supports on the body, fixed and prescribed vertices together:\n" + in_newtons(d.reaction));
  if (simulation.uses_reference() || !simulation.gpu()->has_step()) return;  // the balance is that of a step on the GPU
  const Eigen::Vector3d weight = facts.mass(simulation.model) * simulation.model.gravity;
  const double off = d.imbalance(weight);
  char text[32];
  std::snprintf(text, sizeof text, off < 0.0995 ? "%.1f %%" : "%.0f %%", 100 * off);
  const ImVec4& color = off <= kBalanced ? ui::kGood : off <= kAlmost ? ui::kWarning : ui::kDanger;
  ui::fact(
      "Balance", text,
      "Supports + weight + grabs + contact - mass times acceleration, over the largest of them. Inside the body all "
      "forces cancel, so\nnothing remains of a solved step. The remainder shows how far the iterations are from that. "
      "More "
      "of them help.\nSupports  " +
          in_newtons(d.reaction) + "\nWeight  " + in_newtons(weight) + "\nGrabs  " + in_newtons(d.grab_force) +
          "\nMass times acceleration  " + in_newtons(d.inertia),
      &color);
}

}  // namespace fascia
