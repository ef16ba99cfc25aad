// The tool that a ray meets first.
#include "sim/visual/tool_picking.h"

#include <catch2/catch.hpp>

using namespace fascia;
using Eigen::Vector3d;

TEST_CASE("a ray finds the nearest tool, its jaws included, and none beside them") {
  SceneTools scene;
  scene.ground.emplace();
  scene.instruments.push_back(
      {"ball", ToolShape(SphereShape{{0, 0.1, 0}, 0.02}), std::nullopt, {{0, {0, 0, -0.5}, {0, 0, 0}, 0}}, false});
  scene.instruments.push_back({"jaws",
                               JawsShape{BoxShape{{0.005, 0.1, 0}, {0.005, 0.1, 0.005}, 0}, {0, 0, 1}, 60},
                               std::nullopt,
                               {{0, {0, 0, 0}, {0, 0, 0}, 0}},
                               false});
  const std::vector<Tool> tools = tools_of(scene);
  const std::vector<ToolPlace> places = places_at(tools, 0);
  const auto hit = [&](double x, double y) {
    return pick_tool({Vector3d(x, y, 1), Vector3d(0, 0, -1)}, tools, places, 1);
  };
  REQUIRE(hit(0, 0.1));
  CHECK(hit(0, 0.1)->tool == 1);  // between the open jaws
  CHECK(hit(0, 0.1)->distance == Approx(1.48).epsilon(1e-4));
  for (const double side : {-1.0, 1.0}) {
    REQUIRE(hit(side * 0.1, 0.17));
    CHECK(hit(side * 0.1, 0.17)->tool == 2);
    CHECK(hit(side * 0.1, 0.17)->distance == Approx(0.995).epsilon(1e-4));
  }
  CHECK(!hit(0.3, 0.1));
  CHECK(!hit(0, -0.2));  // the ground, which is left out
}
