// The legend as a file: the texts and colors of the bar in the picture, as SVG and PDF, and the names of regions.
#include "app/overlay/legend_file.h"

#include <catch2/catch.hpp>
#include <regex>
#include <set>

#include "app/charts/chart.h"
#include "app/overlay/color_scale.h"
#include "base/file.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

// All colors that are filled in an SVG, as "#rrggbb", and how far each is from the nearest of the map.
std::set<std::string> fills_of(const std::string& svg) {
  std::set<std::string> fills;
  const std::regex fill("fill *[=:] *['\"]? *(#[0-9a-fA-F]{6}|rgb\\( *[0-9]+, *[0-9]+, *[0-9]+\\))");
  for (std::sregex_iterator it(svg.begin(), svg.end(), fill), end; it != end; ++it) fills.insert((*it)[1]);
  return fills;
}

}  // namespace

TEST_CASE("the legend of a heat map is a file with the bar's numbers, and arrows only where values lie beyond",
          "[legend_file]") {
  Graphics graphics = open_graphics(headless(), false);
  Scene scene = open_scene(source_dir() / "assets/scenes/cube.json");
  scene.display.color = ColorBy::displacement;
  scene.display.legend.side = LegendSide::off;
  scene.display.range = Eigen::Vector2d(-1, 1);
  Session session(graphics, scene, false);
  for (int i = 0; i < 10; ++i) session.simulation.step();
  session.settle_range();
  REQUIRE(has_legend_file(session));
  const TemporaryFolder folder;
  write_legend(folder / "bar.svg", session);
  const std::string svg = read_file(folder / "bar.svg");
  for (const ColorScale::Tick& tick : color_scale(session.look, quantity_of(ColorBy::displacement), {}).ticks) {
    CAPTURE(tick.text);
    CHECK(svg.find(tick.text) != std::string::npos);
  }
  CHECK(svg.find("Displacement") != std::string::npos);
  CHECK(svg.find("<title>Displacement") != std::string::npos);
  CHECK_THAT(svg.substr(0, 400), Catch::Contains("width=\"") && Catch::Contains("height=\""));
  CHECK(fills_of(svg).size() > 60);  // of the gradient

  const auto areas = [&](double low, double high) {
    DisplaySettings display = session.display();
    display.range = Eigen::Vector2d(low, high);
    session.set_display(display);
    session.settle_range();
    write_legend(folder / "bar.svg", session);
    const std::string text = read_file(folder / "bar.svg");
    const std::regex polygon("<polygon|<path d='M[^']*Z");
    return std::distance(std::sregex_iterator(text.begin(), text.end(), polygon), std::sregex_iterator());
  };
  const auto without = areas(-1, 1);
  CHECK(areas(-1, 1e-6) == without + 1);
  CHECK(areas(1e-7, 1e-6) == without + 2);

  write_legend(folder / "bar.pdf", session);
  CHECK(read_file(folder / "bar.pdf").starts_with("%PDF-"));
}

TEST_CASE("the legend of regions is a file with their names and colors", "[legend_file]") {
  Graphics graphics = open_graphics(headless(), false);
  Scene scene = open_scene(source_dir() / "assets/scenes/inclusion.json");
  scene.display.color = ColorBy::region;
  Session session(graphics, scene, false);
  REQUIRE(has_legend_file(session));
  const TemporaryFolder folder;
  write_legend(folder / "regions.svg", session);
  const std::string svg = read_file(folder / "regions.svg");
  REQUIRE(session.regions()->names.size() >= 2);
  for (const std::string& name : session.regions()->names) {
    CAPTURE(name);
    CHECK(svg.find(name) != std::string::npos);
  }
  DisplaySettings display = session.display();
  display.color = ColorBy::none;
  session.set_display(display);
  CHECK(!has_legend_file(session));
}
