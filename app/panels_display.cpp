// What the picture shows of the tissue.
#include <imgui.h>

#include <iterator>

#include "app/panels.h"
#include "app/ui_style.h"
#include "app/ui_widgets.h"

namespace fascia {
namespace {

const char* title_of(ColorBy color) {
  switch (color) {
    case ColorBy::none: return "None";
    case ColorBy::strain: return "Green strain";
    case ColorBy::von_mises: return "Von Mises stress";
    case ColorBy::error: return "True error";
  }
  return "";
}

bool color_combo(ColorBy& color) {
  bool changed = false;
  ui::label("Heat map", "Colors the surface by strain, stress or the distance to the exact step; the bar at the right is its scale");
  if (ImGui::BeginCombo("##color", title_of(color))) {
    for (const ColorBy choice : all_colors()) {
      if (!ImGui::Selectable(title_of(choice), choice == color) || choice == color) continue;
      color = choice;
      changed = true;
    }
    ImGui::EndCombo();
  }
  return changed;
}

// Whether the range follows the largest value, and where it ends if not.
bool range_rows(const Session& session, DisplaySettings& display) {
  bool changed = false, automatic = !display.range;
  ui::label("Range", "Automatic: from 0 to a round number above the largest value of the moment");
  if (ImGui::Checkbox("automatic", &automatic)) {
    display.range.reset();
    if (!automatic) display.range = session.look.range.cast<double>();
    changed = true;
  }
  if (!display.range) return changed;
  const bool stress = display.color == ColorBy::von_mises;
  const bool error = display.color == ColorBy::error;
  const char* unit = stress ? "Pa" : error ? "m" : "";
  const double least = stress ? 1 : error ? 1e-9 : 1e-4, most = stress ? 1e9 : 10;
  Eigen::Vector2d range = *display.range;
  const bool low = ui::number({"from", unit, 0, range.y(), -1e14, 1e14, false, false, "Value of the darkest color"}, range.x());
  const bool high = ui::number({"to", unit, least, most, -1e14, 1e14, true, false, "Value of the brightest color"}, range.y());
  if ((low || high) && range.x() < range.y()) {
    display.range = range;
    changed = true;
  }
  return changed;
}

}  // namespace

void display_panel(Session& session) {
  DisplaySettings display = session.display();
  bool changed = false;
  if (color_combo(display.color)) {
    display.range.reset();  // it was of another quantity
    changed = true;
  }
  if (display.color != ColorBy::none) changed |= range_rows(session, display);
  const float column = ImGui::GetContentRegionAvail().x / 3;
  const float left = ImGui::GetCursorPosX();
  changed |= ImGui::Checkbox("Wireframe", &display.wireframe);
  ui::tooltip("Edges of the surface (W)");
  ImGui::SameLine(left + 1.2f * column);
  ImGui::Checkbox("Shadow", &session.look.shadow);
  ImGui::SameLine(left + 2.15f * column);
  ImGui::Checkbox("Ground", &session.look.ground);
  if (changed) session.set_display(display);
}

}  // namespace fascia
