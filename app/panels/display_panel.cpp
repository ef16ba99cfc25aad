// Settings of the picture.
#include <imgui.h>

#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "app/panels/panels.h"
#include "app/ui/style.h"
#include "app/ui/widgets.h"

namespace fascia {
namespace {

// Whether the range follows the values, and the bounds of a fixed range.
bool range_rows(const Session& session, DisplaySettings& display) {
  bool changed = false, automatic = !display.range;
  ui::label("Range",
            "Automatic: up to a round number above nearly all current values, from 0 or from the same distance on the "
            "other side of a neutral value");
  if (ui::checkbox("automatic", automatic, "Follows the values; off: the range stays fixed and can be typed")) {
    display.range.reset();
    if (!automatic) display.range = session.look.range.cast<double>();
    changed = true;
  }
  if (!display.range) return changed;
  const Quantity& quantity = quantity_of(display.color);
  const bool stress = std::string_view(quantity.unit) == "Pa", length = std::string_view(quantity.unit) == "m";
  const double least = stress ? 1 : length ? 1e-9 : 1e-4, most = stress ? 1e9 : 10;
  Eigen::Vector2d range = *display.range;
  const double lowest = quantity.neutral ? *quantity.neutral - most : 0;
  const bool low = ui::number(
      {"from", quantity.unit, lowest, range.y(), -1e14, 1e14, false, false, "Value of the first color"}, range.x());
  const bool high =
      ui::number({"to", quantity.unit, least, most, -1e14, 1e14, true, false, "Value of the last color"}, range.y());
  if ((low || high) && range.x() < range.y()) {
    display.range = range;
    changed = true;
  }
  return changed;
}

bool section_rows(const Session& session, const char* name, const char* help, std::optional<SectionPlane>& given) {
  bool changed = false, on = given.has_value();
  if (ImGui::Checkbox(name, &on)) {
    given.reset();
    if (on) given = SectionPlane{Eigen::Vector3d::UnitX(), session.look.center.x()};
    changed = true;
  }
  ui::tooltip(help);
  if (!given) return changed;
  SectionPlane& section = *given;
  ui::label("Across",
            "The axis normal to the plane, or its opposite: tissue beyond the plane in this direction is not drawn");
  constexpr const char* kAxes[] = {"x", "y", "z", "-x", "-y", "-z"};
  for (int i = 0; i < 6; ++i) {
    const Eigen::Vector3d axis = (i < 3 ? 1.0 : -1.0) * Eigen::Vector3d::Unit(i % 3);
    if (i > 0) ImGui::SameLine(0, ui::px(2));
    if (ui::button(kAxes[i], ui::px(25), section.normal.normalized().isApprox(axis))) {
      section = {axis, axis.dot(session.look.center)};
      changed = true;
    }
  }
  const double middle = section.normal.normalized().dot(session.look.center), reach = 1.2 * session.look.radius;
  changed |=
      ui::number({"Offset", "m", middle - reach, middle + reach, -1e9, 1e9, false, false,
                  "Distance of the plane from the origin along its normal; Ctrl + left drag also moves the plane"},
                 section.offset);
  return changed;
}

bool tets_rows(const char* name, const char* help, std::optional<SeparateTets>& tets) {
  bool changed = false, on = tets.has_value();
  if (ImGui::Checkbox(name, &on)) {
    tets.reset();
    if (on) tets.emplace();
    changed = true;
  }
  ui::tooltip(help);
  if (!tets) return changed;
  changed |= ui::number({"Shrink", "", 0.1, 1, 0.01, 1, false, false, "Size of every tet about its centroid [-]"},
                        tets->shrink);
  changed |=
      ui::number({"Spread", "", 0, 2, 0, 10, false, false, "How much farther from the middle the tets are drawn [-]"},
                 tets->spread);
  return changed;
}

// Switches, three per row.
class Switches {
 public:
  bool add(const char* name, const char* help, bool& on) {
    constexpr float kColumns[] = {0, 1.2f, 2.15f};  // thirds of the width
    const std::size_t column = count_++ % std::size(kColumns);
    if (column > 0) ImGui::SameLine(left_ + kColumns[column] * third_);
    const bool changed = ImGui::Checkbox(name, &on);
    ui::tooltip(help);
    return changed;
  }

 private:
  float third_ = ImGui::GetContentRegionAvail().x / 3, left_ = ImGui::GetCursorPosX();
  std::size_t count_ = 0;
};

// The switches, and below them the settings with a strength.
bool light_rows(DisplaySettings& display) {
  bool changed = false;
  Switches switches;
  visit_display(display, [&](auto& field, const char*, const char* name, const char* help) {
    if constexpr (std::is_same_v<decltype(field), bool&>) changed |= switches.add(name, help, field);
  });
  visit_display(display, [&](auto& field, const char*, const char* name, const char* help) {
    if constexpr (std::is_same_v<decltype(field), double&>)
      changed |= ui::number({name, "", 0, 1, 0, 1, false, false, help, "off"}, field);
  });
  changed |= ui::choice(
      "Background", all_backgrounds(), display.background, [](Background b) { return name_of(b); },
      [](Background b) { return std::string(help_of(b)); });
  return changed;
}

bool marks_row(const char* name, const char* help, MarkSettings& marks) {
  bool changed = false;
  ImGui::TextUnformatted(name);
  ui::tooltip(help);
  ImGui::PushID(name);
  Switches switches;
  visit_marks(marks, [&](bool& kind, const char* mark, const char* help_of_mark) {
    changed |= switches.add(mark, help_of_mark, kind);
  });
  ImGui::PopID();
  return changed;
}

bool legend_row(const char* name, LegendSettings& legend) {
  return ui::choice(
      name, all_legend_sides(), legend.side, [](LegendSide s) { return name_of(s); },
      [](LegendSide s) { return std::string(help_of(s)); });
}

void theme_row() {
  ui::label("Panels", "Colors of these panels, for bright and for dark rooms");
  for (const auto& [theme, name] : {std::pair{ui::Theme::dark, "dark"}, std::pair{ui::Theme::light, "light"}}) {
    if (theme != ui::Theme::dark) ImGui::SameLine();
    if (ui::button(name, ui::px(70), ui::theme() == theme)) ui::set_theme(theme);
  }
}

// Takes effect when the slider is released: a panel that grows under the mouse cannot be set.
void scale_row() {
  constexpr const char* kHelp =
      "Size of texts and panels, on top of the scale of the monitor; kept for the next start. Ctrl + click types a "
      "number";
  ui::label("Scale", kHelp);
  float& wanted = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("wanted scale"), 100 * ui::interface_scale());
  ImGui::SliderFloat("##scale", &wanted, 100 * ui::kLeastScale, 100 * ui::kLargestScale, "%.0f %%",
                     ImGuiSliderFlags_AlwaysClamp);
  ui::tooltip(kHelp);
  if (ImGui::IsItemActive()) return;
  constexpr float kStep = 5;  // percent
  const float rounded = kStep * std::round(wanted / kStep);
  if (ImGui::IsItemDeactivatedAfterEdit()) ui::set_interface_scale(rounded / 100);
  wanted = 100 * ui::interface_scale();
}

}  // namespace

void display_panel(const PanelContext& context) {
  Session& session = context.session;
  DisplaySettings display = session.display();
  bool changed = false;
  if (ui::choice(
          "Color", all_colors(), display.color, [](ColorBy c) { return quantity_of(c).title; },
          [](ColorBy c) { return std::string(help_of(c)); })) {
    display.range.reset();  // the range belonged to another quantity
    changed = true;
  }
  if (is_heat_map(display.color)) {
    changed |= ui::choice(
        "Color map", all_color_maps(), display.color_map, [](ColorMap m) { return name_of(m); },
        [](ColorMap m) { return std::string(help_of(m)); });
    changed |= range_rows(session, display);
  }
  changed |= light_rows(display);
  visit_display(display, [&](auto& field, const char*, const char* name, const char* help) {
    if constexpr (std::is_same_v<decltype(field), std::optional<SectionPlane>&>)
      changed |= section_rows(session, name, help, field);
    if constexpr (std::is_same_v<decltype(field), std::optional<SeparateTets>&>)
      changed |= tets_rows(name, help, field);
    if constexpr (std::is_same_v<decltype(field), MarkSettings&>) changed |= marks_row(name, help, field);
    if constexpr (std::is_same_v<decltype(field), LegendSettings&>)
      if (display.color != ColorBy::none) changed |= legend_row(name, field);
  });
  theme_row();
  scale_row();
  if (changed) session.set_display(display);
}

}  // namespace fascia
