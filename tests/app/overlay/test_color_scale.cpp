// The content of a color bar: ticks at round numbers with their units, colors of the map at every share.
#include "app/overlay/color_scale.h"

#include <catch2/catch.hpp>

using namespace fascia;

TEST_CASE("a color scale has ticks at both ends of a round range, in the quantity's unit", "[color_scale]") {
  Look look;
  look.range = {0, 2000};
  const ColorScale scale = color_scale(look, quantity_of(ColorBy::von_mises), {false, true});
  CHECK(scale.title == "Von Mises stress");
  REQUIRE(scale.ticks.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) CHECK(scale.ticks[i].share == Approx(0.25 * static_cast<double>(i)));
  CHECK(scale.ticks[0].text == "0 Pa");
  CHECK(scale.ticks[1].text == "500 Pa");
  CHECK(scale.ticks[4].text == "2 kPa");
  CHECK(scale.beyond == std::array{false, true});
}

TEST_CASE("a color scale without a unit has as many decimals as its steps", "[color_scale]") {
  Look look;
  look.range = {0.95f, 1.05f};
  const ColorScale scale = color_scale(look, quantity_of(ColorBy::volume_ratio), {});
  CHECK(scale.ticks.front().text == "0.95");
  CHECK(scale.ticks.back().text == "1.05");
  CHECK(scale.ticks.back().share == Approx(1).epsilon(1e-5));
}

TEST_CASE("colors are those of the map over the range, of which a neutral value is the middle", "[color_scale]") {
  Look look;
  look.range = {0, 10};
  CHECK(color_at(look, 0) == color_maps::dusk(0));
  CHECK(color_at(look, 0.5f) == color_maps::dusk(0.5f));
  CHECK(color_at(look, 1) == color_maps::dusk(1));
  look.color_map = &color_maps::polar;
  look.neutral = 0.0f;
  CHECK(color_at(look, 0) == color_maps::polar(0.5f));
  CHECK(color_at(look, 1) == color_maps::polar(1));
}
