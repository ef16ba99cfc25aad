// Tools off their paths: their places in numbers, and their motion.
#include "sim/tool/led_tools.h"

#include <catch2/catch.hpp>
#include <random>

#include "base/rotation.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

Instrument moving(const std::string& name) {
  Instrument instrument;
  instrument.name = name;
  instrument.shape = ToolShape(SphereShape{{0, 0, 0}, 0.01});
  instrument.path = {{0, {0, 0, 0}, {0, 0, 0}, 0}, {1, {1, 0, 0}, {0, 0, 0}, 0}};
  return instrument;
}

}  // namespace

TEST_CASE("the angles of a place give its axes back, also where two axes coincide") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angle(-180, 180), tiny(-1e-7, 1e-7);
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    Vector3d angles(angle(random), angle(random), angle(random));
    if (i % 3 == 0) angles.y() = (i % 2 == 0 ? 90 : -90) + (i % 4 == 0 ? 0 : tiny(random));
    const ToolPlace place{{rotation_of(angles), {0.1, 0.2, 0.3}}, 0.25};
    const LedPlace led = led_place(place);
    worst = std::max(worst, (led.place().pose.axes - place.pose.axes).norm());
    CHECK(led.place().pose.origin == place.pose.origin);
    CHECK(led.place().grip == 0.25);
  }
  INFO("worst error of the axes " << worst);
  CHECK(worst < 1e-14);
}

TEST_CASE("a led tool leaves its path from where it is, and the others stay on theirs") {
  SceneTools scene;
  scene.instruments = {moving("one"), moving("two")};
  const std::vector<Tool> tools = tools_of(scene);
  LedTools led;
  CHECK(led.empty());
  CHECK(led.motion(tools, 0.25, 0.5) == motion_on_paths(tools, 0.25, 0.5));

  led.lead({"two", {{0, 7, 0}, {0, 0, 90}, 0}});
  const ToolMotion first = led.motion(tools, 0.25, 0.5);
  CHECK(first.from == motion_on_paths(tools, 0.25, 0.5).from);
  CHECK(first.to[0].pose.origin == Vector3d(0.5, 0, 0));
  CHECK(first.to[1].pose.origin == Vector3d(0, 7, 0));
  CHECK(first.to[1].pose.axes == rotation_of({0, 0, 90}));

  led.arrive();
  const ToolMotion rests = led.motion(tools, 0.5, 0.75);
  CHECK(rests.from[1] == first.to[1]);
  CHECK(rests.to[1] == first.to[1]);

  const std::vector<LedTool> kept = led.tools();
  led.lead({"two", {{0, 8, 0}, {0, 0, 0}, 0}});
  CHECK(led.motion(tools, 0.5, 0.75).from[1] == first.to[1]);
  led.restart(kept);
  CHECK(led.motion(tools, 0.5, 0.75) == rests);
  led.restart({});
  CHECK(led.motion(tools, 0.5, 0.75) == motion_on_paths(tools, 0.5, 0.75));
}
