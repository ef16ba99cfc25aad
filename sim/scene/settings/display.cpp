#include "sim/scene/settings/display.h"

#include <array>
#include <cstddef>

namespace fascia {

const Quantity& quantity_of(ColorBy color) {
  static const std::array<Quantity, 10> quantities{{{"none", "None", "", {}},
                                                    {"region", "Region", "", {}},
                                                    {"strain", "Green strain, Frobenius norm", "", {}},
                                                    {"von_mises", "von Mises stress", "Pa", {}},
                                                    {"displacement", "Displacement", "m", {}},
                                                    {"velocity", "Velocity", "m/s", {}},
                                                    {"volume_ratio", "Volume ratio J", "", 1.0},
                                                    {"largest_stress", "Largest principal stress", "Pa", 0.0},
                                                    {"smallest_stress", "Smallest principal stress", "Pa", 0.0},
                                                    {"error", "distance to the exact step", "m", {}}}};
  return quantities[static_cast<std::size_t>(color)];
}

std::string label_of(ColorBy color) {
  const Quantity& quantity = quantity_of(color);
  return std::string(quantity.title) + " [" + (*quantity.unit ? quantity.unit : "-") + "]";
}

const std::vector<ColorBy>& all_colors() {
  static const std::vector<ColorBy> colors = {ColorBy::none,         ColorBy::region,         ColorBy::strain,
                                              ColorBy::von_mises,    ColorBy::displacement,   ColorBy::velocity,
                                              ColorBy::volume_ratio, ColorBy::largest_stress, ColorBy::smallest_stress,
                                              ColorBy::error};
  return colors;
}

const char* name_of(ColorMap map) {
  switch (map) {
    case ColorMap::automatic:
      return "automatic";
    case ColorMap::dusk:
      return "dusk";
    case ColorMap::ember:
      return "ember";
    case ColorMap::polar:
      return "polar";
    case ColorMap::grey:
      return "grey";
  }
  return "";
}

const std::vector<ColorMap>& all_color_maps() {
  static const std::vector<ColorMap> maps = {ColorMap::automatic, ColorMap::dusk, ColorMap::ember, ColorMap::polar,
                                             ColorMap::grey};
  return maps;
}

ColorMap chosen_map(ColorMap map, ColorBy color) {
  if (map != ColorMap::automatic) return map;
  return quantity_of(color).neutral ? ColorMap::polar : ColorMap::dusk;
}

const char* name_of(Background background) {
  switch (background) {
    case Background::gradient:
      return "gradient";
    case Background::white:
      return "white";
    case Background::black:
      return "black";
    case Background::transparent:
      return "transparent";
  }
  return "";
}

const std::vector<Background>& all_backgrounds() {
  static const std::vector<Background> backgrounds = {Background::gradient, Background::white, Background::black,
                                                      Background::transparent};
  return backgrounds;
}

}  // namespace fascia
