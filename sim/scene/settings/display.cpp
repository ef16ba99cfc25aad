#include "sim/scene/settings/display.h"

#include <array>
#include <cstddef>
#include <iterator>

namespace fascia {
namespace {

struct Choice {
  const char *name, *help;
};
// In the order of the enumerations.
constexpr Choice kColorMaps[] = {
    {"automatic", "dusk; polar for J and principal stresses"},
    {"dusk", "Violet over green to yellow, always lighter"},
    {"ember", "Black over red to yellow, always lighter"},
    {"polar", "Blue, white, red: white is the neutral value of J (1) and principal stresses (0), else the middle"},
    {"grey", "Dark to light, for print"},
};
constexpr Choice kBackgrounds[] = {
    {"gradient", "A grey room"},
    {"white", "For papers"},
    {"black", "For slides"},
    {"transparent", "Pictures get an alpha channel; of the ground only the shadow is kept. No videos"},
};

constexpr Choice kLegendSides[] = {
    {"right", "At the right edge, halfway up"},
    {"left", "At the left edge, halfway up"},
    {"off", "No legend"},
};

template <class Enumeration, class Table>
std::vector<Enumeration> all_of(const Table& table) {
  std::vector<Enumeration> all;
  for (std::size_t i = 0; i < std::size(table); ++i) all.push_back(static_cast<Enumeration>(i));
  return all;
}

const std::array<Quantity, 13>& quantities() {
  static const std::array<Quantity, 13> table{
      {{"none", "None", "", "The tissue's own color. Costs nothing"},
       {"region", "Region", "",
        "Regions of the mesh, in colors that color-blind people tell apart. Costs nothing in a step"},
       {"strain", "Green strain, Frobenius norm", "",
        "Green strain of the tets, averaged at vertices [-]. One pass over the tets a frame"},
       {"von_mises", "Von Mises stress", "Pa",
        "Of the Cauchy stress, averaged at vertices [Pa]. One pass over the tets a frame"},
       {"displacement", "Displacement", "m", "Distance from the place at rest [m]. Costs next to nothing"},
       {"velocity", "Velocity", "m/s", "Speed of the vertices [m/s]. Costs next to nothing"},
       {"volume_ratio", "Volume ratio J", "",
        "J, volume over volume at rest [-]: 1 is unchanged, below 0 turned inside out. One pass over the tets a frame",
        1.0},
       {"largest_stress", "Largest principal stress", "Pa",
        "Of the Cauchy stress [Pa]: positive where the tissue is pulled. One pass over the tets a frame", 0.0},
       {"smallest_stress", "Smallest principal stress", "Pa",
        "Of the Cauchy stress [Pa]: negative where the tissue is pressed. One pass over the tets a frame", 0.0},
       {"error", "Distance to the exact step", "m",
        "Distance of the last substep to the exact one [m], solved on another thread"},
       {"contact_pressure", "Contact pressure", "Pa",
        "Of ground, obstacles, instruments and other tissue, over the area at rest [Pa]. Costs next to nothing"},
       {"mesh_error", "Estimated error of the mesh", "",
        "Error of the stresses in the energy norm over the body's mean [-]: where a finer mesh helps. Estimated on "
        "another thread"},
       {"recovered_von_mises", "Von Mises stress, recovered", "Pa",
        "Of the Cauchy stress, recovered at vertices from the tets around [Pa]: nearer to the stress of a finer mesh. "
        "Computed on another thread"}}};
  return table;
}

}  // namespace

const Quantity& quantity_of(ColorBy color) { return quantities()[static_cast<std::size_t>(color)]; }

std::string label_of(ColorBy color) {
  const Quantity& quantity = quantity_of(color);
  return std::string(quantity.title) + " [" + (*quantity.unit ? quantity.unit : "-") + "]";
}

const std::vector<ColorBy>& all_colors() {
  static const std::vector<ColorBy> colors = all_of<ColorBy>(quantities());
  return colors;
}

ColorMap chosen_map(ColorMap map, ColorBy color) {
  if (map != ColorMap::automatic) return map;
  return quantity_of(color).neutral ? ColorMap::polar : ColorMap::dusk;
}

const std::vector<ColorMap>& all_color_maps() {
  static const std::vector<ColorMap> maps = all_of<ColorMap>(kColorMaps);
  return maps;
}
const char* name_of(ColorMap map) { return kColorMaps[static_cast<std::size_t>(map)].name; }
const char* help_of(ColorMap map) { return kColorMaps[static_cast<std::size_t>(map)].help; }

const std::vector<Background>& all_backgrounds() {
  static const std::vector<Background> backgrounds = all_of<Background>(kBackgrounds);
  return backgrounds;
}
const char* name_of(Background background) { return kBackgrounds[static_cast<std::size_t>(background)].name; }
const char* help_of(Background background) { return kBackgrounds[static_cast<std::size_t>(background)].help; }

const std::vector<LegendSide>& all_legend_sides() {
  static const std::vector<LegendSide> sides = all_of<LegendSide>(kLegendSides);
  return sides;
}
const char* name_of(LegendSide side) { return kLegendSides[static_cast<std::size_t>(side)].name; }
const char* help_of(LegendSide side) { return kLegendSides[static_cast<std::size_t>(side)].help; }

}  // namespace fascia
