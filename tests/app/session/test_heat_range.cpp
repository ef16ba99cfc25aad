// The automatic range of a heat map: it depends on the shown values, not on earlier pictures, and a few large values do
// not set it; the two sides of a comparison share one.
// Covers: shown_look, sim/gpu/readback/shown_range
#include <catch2/catch.hpp>
#include <tuple>

#include "app/compare/split_view.h"
#include "app/session/shown_look.h"
#include "render/target/image.h"
#include "sim/grab/build_model.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

Scene cube(ColorBy color) {
  Scene scene = open_scene(source_dir() / "assets/scenes/cube.json");
  scene.display.color = color;
  return scene;
}

/// Pulls a free vertex by `force` and steps until it has moved.
void pull(Session& session, double stiffness) {
  const std::vector<char> held = session.simulation.model.held();
  std::uint32_t v = 0;
  while (held[v]) ++v;
  session.simulation.set_grab({{v, Eigen::Vector3d(0, 0.02, 0), stiffness}});
  for (int i = 0; i < 5; ++i) session.simulation.step();
}

}  // namespace

TEST_CASE("a range is initially absent, grows at once and shrinks late", "[heat_range]") {
  std::optional<Eigen::Vector2f> range;
  const auto follows = [&](double low, double high, ColorBy color = ColorBy::displacement) {
    const double middle = quantity_of(color).neutral.value_or(0);
    follow_range({low, high, std::max(middle - low, high - middle)}, color, false, range);
    return range;
  };
  CHECK_FALSE(follows(0, 0));
  CHECK(follows(0, 0.351) == Eigen::Vector2f(0, 0.5f));
  CHECK(follows(0, 0.11) == Eigen::Vector2f(0, 0.5f));
  CHECK(follows(0, 0) == Eigen::Vector2f(0, 0.5f));
  CHECK(follows(0, 0.6) == Eigen::Vector2f(0, 1));
  CHECK(follows(0, 0.19) == Eigen::Vector2f(0, 0.2f));
  range.reset();
  CHECK(follows(0.9, 1.3, ColorBy::volume_ratio) == Eigen::Vector2f(0.5f, 1.5f));
}

TEST_CASE("two percent of the values may lie beyond the range, but none by more than ten times", "[heat_range]") {
  const auto range_of = [](const ShownValues& shown, ColorBy color) {
    std::optional<Eigen::Vector2f> range;
    follow_range(shown, color, false, range);
    return range.value_or(Eigen::Vector2f(-1, -1));
  };
  CHECK(range_of({0, 900, 190}, ColorBy::von_mises) == Eigen::Vector2f(0, 200));
  CHECK(range_of({0, 9000, 190}, ColorBy::von_mises) == Eigen::Vector2f(0, 1000));
  CHECK(range_of({0, 4, 0}, ColorBy::velocity) == Eigen::Vector2f(0, 0.5f));
  CHECK(range_of({-900, 40, 190}, ColorBy::smallest_stress) == Eigen::Vector2f(-200, 200));
}

TEST_CASE("the range of a video only grows", "[heat_range]") {
  std::optional<Eigen::Vector2f> range;
  std::vector<float> ends;
  for (const double value : {0.0, 0.3, 0.01, 0.7, 0.02, 0.0}) {
    follow_range({0, value, value}, ColorBy::displacement, true, range);
    ends.push_back(range ? range->y() : 0);
  }
  CHECK(ends == std::vector<float>{0, 0.5f, 0.5f, 1, 1, 1});
}

TEST_CASE("values beyond the range are known, with an automatic and with a fixed one", "[heat_range]") {
  Graphics graphics = open_graphics(headless(), false);
  Session session(graphics, cube(ColorBy::displacement), false);
  pull(session, 50);
  session.settle_range();
  const State state = session.simulation.state();
  double largest = 0;
  for (const Eigen::Vector3d& u : state.displacement) largest = std::max(largest, u.norm());
  CAPTURE(largest, session.look.range.y());
  CHECK(session.beyond_range() == std::array{false, largest > session.look.range.y()});
  DisplaySettings display = session.display();
  for (const auto& [low, high, below, above] : {std::tuple(-1.0, 2 * largest, false, false),
                                                {0.5 * largest, 2 * largest, true, false},
                                                {0.1 * largest, 0.5 * largest, true, true}}) {
    display.range = Eigen::Vector2d(low, high);
    session.set_display(display);
    session.settle_range();
    CAPTURE(low, high);
    CHECK(session.beyond_range() == std::array{below, above});
  }
  display.color = ColorBy::none;
  session.set_display(display);
  CHECK(session.beyond_range() == std::array{false, false});
}

TEST_CASE("pictures of one state have one range, regardless of earlier pictures", "[heat_range]") {
  Graphics graphics = open_graphics(headless(), false);
  Session session(graphics, cube(ColorBy::displacement), false);
  pull(session, 50);
  session.settle_range();
  const Eigen::Vector2f displacement = session.look.range;
  CHECK(displacement.y() < 0.2f);

  INFO("another quantity and back");
  DisplaySettings display = session.display();
  display.color = ColorBy::von_mises;
  session.set_display(display);
  session.settle_range();
  CHECK(session.look.range.y() > 1);
  display.color = ColorBy::displacement;
  session.set_display(display);
  session.settle_range();
  CHECK(session.look.range == displacement);

  INFO("fixed and back");
  display.range = Eigen::Vector2d(0, 3 * displacement.y());
  session.set_display(display);
  session.settle_range();
  CHECK(session.look.range.y() == 3 * displacement.y());
  display.range.reset();
  session.set_display(display);
  session.settle_range();
  CHECK(session.look.range == displacement);
}

TEST_CASE("the first picture of a quantity already has its range", "[heat_range]") {
  Graphics graphics = open_graphics(headless(), false);
  Session session(graphics, cube(ColorBy::none), false);
  pull(session, 30);
  for (const ColorBy color : {ColorBy::von_mises, ColorBy::displacement, ColorBy::von_mises, ColorBy::strain}) {
    DisplaySettings display = session.display();
    display.color = color;
    session.set_display(display);
    session.follow_range();  // as before each picture of a window
    const Eigen::Vector2f first = session.look.range;
    session.settle_range();
    CAPTURE(name_of(color), first.transpose(), session.look.range.transpose());
    CHECK(first == session.look.range);
    CHECK(first != Look().range);
  }
}

TEST_CASE("a range is known once there are values to follow", "[heat_range]") {
  Graphics graphics = open_graphics(headless(), false);
  Session session(graphics, cube(ColorBy::von_mises), false);
  session.settle_range();
  CHECK_FALSE(session.has_range());  // at rest nothing is strained
  session.simulation.step();
  session.settle_range();
  CHECK(session.has_range());
  session.forget_range();
  CHECK_FALSE(session.has_range());
  DisplaySettings display = session.display();
  display.range = Eigen::Vector2d(0, 10);
  session.set_display(display);
  CHECK(session.has_range());
}

TEST_CASE("render says why the error of the solver has no colors", "[heat_range]") {
  const TemporaryFolder folder;
  const auto note_of = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"render", cube_path(), "--context", "osmesa", "--size",
                                       "96x64",  "--color",   "error",     "--out",  folder / "shot.png"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const CommandResult result = run_fascia(arguments);
    CAPTURE(result.err);
    REQUIRE(result.exit_code == 0);
    const std::size_t at = result.err.find("display.color=error has no colors");
    return at == std::string::npos ? "" : result.err.substr(at, result.err.find('\n', at) - at);
  };
  const std::string begin = "display.color=error has no colors: it compares the last step with an exact one, and ";
  CHECK(note_of({"--static"}) == begin + "--static takes no steps");
  CHECK(note_of({"--steps", "0"}) == begin + "no step was taken");
  CHECK(note_of({"--steps", "1", "--reference"}) == begin + "the steps of --reference are exact");
  CHECK(note_of({"--steps", "1"}).empty());
  CHECK(note_of({"--static", "--quiet"}).empty());
}

TEST_CASE("a final picture is the same after a video", "[heat_range]") {
  const TemporaryFolder folder;
  const std::string scene = (source_dir() / "assets/scenes/cube.json").string();
  std::vector<Image> pictures;
  for (const bool video : {false, true}) {
    const std::string png = folder / (video ? "after.png" : "alone.png");
    // The range falls to less than a half, but not to a fifth, of that of the video.
    std::vector<std::string> arguments{"render",  scene, "--context", "osmesa",   "--size", "96x64", "--quiet",
                                       "--steps", "40",  "--color",   "velocity", "--out",  png};
    if (video) arguments.insert(arguments.end(), {"--video", folder / "%03d.png"});
    const CommandResult result = run_fascia(arguments);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    pictures.push_back(read_png(png));
  }
  CHECK(pictures[0].rgba == pictures[1].rgba);
}

TEST_CASE("both sides of a comparison are within the range that they share", "[heat_range]") {
  Graphics graphics = open_graphics(headless(), false);
  Session a(graphics, cube(ColorBy::displacement), false);
  Scene soft = cube(ColorBy::displacement);
  soft.bodies[0].material.young_modulus /= 50;
  SplitView split(graphics, a, soft, build_model(soft));
  pull(a, 50);
  pull(split.b(), 50);
  for (Session* side : {&a, &split.b()}) {
    side->settle_range();
    CAPTURE(side->look.range.y());
  }
  const float own_a = a.look.range.y(), own_b = split.b().look.range.y();
  REQUIRE(own_b > 2 * own_a);
  const bool now = GENERATE(true, false);
  for (int frame = 0; frame < 3; ++frame) now ? a.settle_range(&split.b()) : a.follow_range(&split.b());
  if (!now) a.settle_range(&split.b());
  CHECK(a.look.range.y() == own_b);
  Framebuffer framebuffer(64, 32, 1);
  split.draw(a, framebuffer, {}, {});
  CHECK(split.b().look.range == a.look.range);
  CHECK(a.look.range.y() == own_b);
}
