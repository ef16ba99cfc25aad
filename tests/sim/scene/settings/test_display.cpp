// Display settings: names, titles and units of all choices.
#include "sim/scene/settings/display.h"

#include <catch2/catch.hpp>
#include <set>

using namespace fascia;

namespace {

template <class Enumeration>
void check_table(const std::vector<Enumeration>& all, std::size_t count) {
  CHECK(all.size() == count);
  std::set<std::string> names;
  for (std::size_t i = 0; i < all.size(); ++i) {
    CAPTURE(i, name_of(all[i]));
    CHECK(static_cast<std::size_t>(all[i]) == i);
    CHECK(names.insert(name_of(all[i])).second);
    CHECK(std::string(help_of(all[i])).size() > 5);
  }
}

}  // namespace

TEST_CASE("every value of an enumeration has a unique name and a help, in order") {
  check_table(all_colors(), static_cast<std::size_t>(ColorBy::recovered_von_mises) + 1);
  check_table(all_color_maps(), static_cast<std::size_t>(ColorMap::grey) + 1);
  check_table(all_backgrounds(), static_cast<std::size_t>(Background::transparent) + 1);
  check_table(all_legend_sides(), static_cast<std::size_t>(LegendSide::off) + 1);
}

TEST_CASE("names are those of their values") {
  CHECK(std::string(name_of(ColorBy::none)) == "none");
  CHECK(std::string(name_of(ColorBy::region)) == "region");
  CHECK(std::string(name_of(ColorBy::von_mises)) == "von_mises");
  CHECK(std::string(name_of(ColorBy::volume_ratio)) == "volume_ratio");
  CHECK(std::string(name_of(ColorBy::smallest_stress)) == "smallest_stress");
  CHECK(std::string(name_of(ColorBy::error)) == "error");
  CHECK(std::string(name_of(ColorBy::contact_pressure)) == "contact_pressure");
  CHECK(std::string(name_of(ColorBy::mesh_error)) == "mesh_error");
  CHECK(std::string(name_of(ColorMap::dusk)) == "dusk");
  CHECK(std::string(name_of(ColorMap::polar)) == "polar");
  CHECK(std::string(name_of(ColorMap::grey)) == "grey");
  CHECK(std::string(name_of(Background::white)) == "white");
  CHECK(std::string(name_of(Background::transparent)) == "transparent");
}

TEST_CASE("labels have the unit, or a dash for none") {
  CHECK(label_of(ColorBy::von_mises) == "Von Mises stress [Pa]");
  CHECK(label_of(ColorBy::displacement) == "Displacement [m]");
  CHECK(label_of(ColorBy::velocity) == "Velocity [m/s]");
  CHECK(label_of(ColorBy::volume_ratio) == "Volume ratio J [-]");
  for (const ColorBy color : all_colors()) {
    const std::string title = quantity_of(color).title;
    CHECK((title[0] >= 'A' && title[0] <= 'Z'));
  }
}

TEST_CASE("signed quantities have the map whose middle is their neutral value") {
  for (const ColorBy color : all_colors()) {
    const bool both_ways =
        color == ColorBy::volume_ratio || color == ColorBy::largest_stress || color == ColorBy::smallest_stress;
    CAPTURE(name_of(color));
    CHECK(quantity_of(color).neutral.has_value() == both_ways);
    CHECK(chosen_map(ColorMap::automatic, color) == (both_ways ? ColorMap::polar : ColorMap::dusk));
    for (const ColorMap map : {ColorMap::dusk, ColorMap::ember, ColorMap::polar, ColorMap::grey})
      CHECK(chosen_map(map, color) == map);
    CHECK(is_heat_map(color) == (color != ColorBy::none && color != ColorBy::region));
  }
  CHECK(quantity_of(ColorBy::volume_ratio).neutral == 1.0);
  CHECK(quantity_of(ColorBy::largest_stress).neutral == 0.0);
}

TEST_CASE("every setting is visited once, with a unique key") {
  DisplaySettings settings;
  std::set<std::string> keys;
  int count = 0;
  visit_display(settings, [&](auto&, const char* key, const char* label, const char* help) {
    CAPTURE(key);
    CHECK(keys.insert(key).second);
    CHECK(*label != '\0');
    CHECK(*help != '\0');
    ++count;
  });
  CHECK(count == 13);
}
