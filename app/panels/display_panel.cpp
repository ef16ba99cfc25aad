// What the picture shows of the tissue.
#include <imgui.h>

#include <string_view>
#include <utility>

#include "app/panels/panels.h"
#include "app/ui/style.h"
#include "app/ui/widgets.h"

namespace fascia {
namespace {

const char* help_of(ColorBy color) {
  switch (color) {
    case ColorBy::none:
      return "The tissue's own color. Costs nothing";
    case ColorBy::region:
      return "Regions of the mesh, in colors that color-blind people tell apart. Costs nothing in a step";
    case ColorBy::strain:
      return "Green strain of the tets, averaged at vertices [-]. One pass over the tets a frame";
    case ColorBy::von_mises:
      return "Of the Cauchy stress, averaged at vertices [Pa]. One pass over the tets a frame";
    case ColorBy::displacement:
      return "Distance from the place at rest [m]. Costs next to nothing";
    case ColorBy::velocity:
      return "Speed of the vertices [m/s]. Costs next to nothing";
    case ColorBy::volume_ratio:
      return "J, volume over volume at rest [-]: 1 is unchanged, below 0 turned inside out. One pass over the tets a "
             "frame";
    case ColorBy::largest_stress:
      return "Of the Cauchy stress [Pa]: positive where the tissue is pulled. One pass over the tets a frame";
    case ColorBy::smallest_stress:
      return "Of the Cauchy stress [Pa]: negative where the tissue is pressed. One pass over the tets a frame";
    case ColorBy::error:
      return "Distance of the last substep to the exact one [m], solved on another thread";
  }
  return "";
}

const char* help_of(ColorMap map) {
  switch (map) {
    case ColorMap::automatic:
      return "dusk; polar for J and principal stresses";
    case ColorMap::dusk:
      return "Violet over green to yellow, always lighter";
    case ColorMap::ember:
      return "Black over red to yellow, always lighter";
    case ColorMap::polar:
      return "Blue, white, red: white is the neutral value of J (1) and principal stresses (0), else the middle";
    case ColorMap::grey:
      return "Dark to light, for print";
  }
  return "";
}

const char* help_of(Background background) {
  switch (background) {
    case Background::gradient:
      return "A grey room";
    case Background::white:
      return "For papers";
    case Background::black:
      return "For slides";
    case Background::transparent:
      return "Pictures get an alpha channel; of the ground only the shadow is kept. No videos";
  }
  return "";
}

// Whether the range follows the values, and where it ends if not.
bool range_rows(const Session& session, DisplaySettings& display) {
  bool changed = false, automatic = !display.range;
  ui::label("Range",
            "Automatic: to a round number above the largest value of the moment, from 0 or as far to the other side of "
            "a neutral value");
  if (ui::checkbox("automatic", automatic, "Follows the values; off: the range stays as it is and can be typed")) {
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

bool section_rows(const Session& session, DisplaySettings& display) {
  bool changed = false, on = display.section.has_value();
  if (ImGui::Checkbox("Section", &on)) {
    display.section.reset();
    if (on) display.section = SectionPlane{Eigen::Vector3d::UnitX(), session.look.center.x()};
    changed = true;
  }
  ui::tooltip(
      "Cuts the picture of the body open; what is inside shows in the colors of the heat map. One pass over the tets a "
      "frame");
  if (!display.section) return changed;
  SectionPlane& section = *display.section;
  ui::label("Across",
            "The axis that the plane lies across, or its opposite: what lies beyond the plane along it is left out");
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
  changed |= ui::number({"Offset", "m", middle - reach, middle + reach, -1e9, 1e9, false, false,
                         "Of the plane from the origin along its normal; Ctrl + left drag moves it, too"},
                        section.offset);
  return changed;
}

bool tets_rows(DisplaySettings& display) {
  bool changed = false, on = display.tets.has_value();
  if (ImGui::Checkbox("Separate tets", &on)) {
    display.tets.reset();
    if (on) display.tets.emplace();
    changed = true;
  }
  ui::tooltip(
      "Draws every tet on its own instead of the surface: 4 triangles a tet. With a section whole tets are left out");
  if (!display.tets) return changed;
  changed |= ui::number({"Shrink", "", 0.1, 1, 0.01, 1, false, false, "Size of every tet about its centroid [-]"},
                        display.tets->shrink);
  changed |=
      ui::number({"Spread", "", 0, 2, 0, 10, false, false, "How much farther from the middle tets are drawn [-]"},
                 display.tets->spread);
  return changed;
}

bool light_rows(DisplaySettings& display) {
  const float column = ImGui::GetContentRegionAvail().x / 3, left = ImGui::GetCursorPosX();
  bool changed = ImGui::Checkbox("Wireframe", &display.wireframe);
  ui::tooltip("Edges of the surface, and of the tets in a section (W)");
  ImGui::SameLine(left + 1.2f * column);
  changed |= ImGui::Checkbox("Shadow", &display.shadow);
  ui::tooltip("Draws the scene a second time, as the light sees it");
  ImGui::SameLine(left + 2.15f * column);
  changed |= ImGui::Checkbox("Ground", &display.ground);
  ui::tooltip("A floor with a grid; every line is a round number of metres");
  changed |= ui::number(
      {"Occlusion", "", 0, 1, 0, 1, false, false,
       "Darkens creases and what stands close together [-]. 0 costs nothing; software renderers pay for every pixel"},
      display.ambient_occlusion);
  changed |= ui::number(
      {"Depth cue", "", 0, 1, 0, 1, false, false, "How far the back of the scene fades into the background [-]"},
      display.depth_cue);
  changed |= ui::choice(
      "Background", all_backgrounds(), display.background, [](Background b) { return name_of(b); },
      [](Background b) { return std::string(help_of(b)); });
  return changed;
}

void theme_row() {
  ui::label("Panels", "Colors of these panels, for bright and for dark rooms");
  for (const auto& [theme, name] : {std::pair{ui::Theme::dark, "dark"}, std::pair{ui::Theme::light, "light"}}) {
    if (theme != ui::Theme::dark) ImGui::SameLine();
    if (ui::button(name, ui::px(70), ui::theme() == theme)) ui::set_theme(theme);
  }
}

}  // namespace

void display_panel(Session& session) {
  DisplaySettings display = session.display();
  bool changed = false;
  if (ui::choice(
          "Color", all_colors(), display.color, [](ColorBy c) { return quantity_of(c).title; },
          [](ColorBy c) { return std::string(help_of(c)); })) {
    display.range.reset();  // it was of another quantity
    changed = true;
  }
  if (is_heat_map(display.color)) {
    changed |= ui::choice(
        "Color map", all_color_maps(), display.color_map, [](ColorMap m) { return name_of(m); },
        [](ColorMap m) { return std::string(help_of(m)); });
    changed |= range_rows(session, display);
  }
  changed |= light_rows(display);
  changed |= section_rows(session, display);
  changed |= tets_rows(display);
  theme_row();
  if (changed) session.set_display(display);
}

}  // namespace fascia
