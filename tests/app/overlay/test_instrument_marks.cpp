// Which instruments have marks, and where.
#include "app/overlay/instrument_marks.h"

#include <catch2/catch.hpp>

#include "app/session/graphics.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

TEST_CASE("an instrument that touches shows its force, and the one in hand its gap; the ground has no mark") {
  Graphics graphics = open_graphics(headless(), false);
  Scene scene = open_scene(source_dir() / "assets/scenes/cube.json");
  scene.tools.ground.emplace();
  scene.tools.ground->height = -1;
  const BoxShape jaw{{0.01, -0.04, 0}, {0.01, 0.04, 0.01}, 0};
  scene.tools.instruments.push_back(
      {"ball", ToolShape(SphereShape{{0, 0, 0}, 0.01}), std::nullopt, {{0, {0, 0.2, 0}, {0, 0, 0}, 0}}, false});
  scene.tools.instruments.push_back(
      {"forceps", JawsShape{jaw, {0, 0, 1}, 0}, std::nullopt, {{0, {0.3, 0.2, 0}, {0, 0, 0}, 0}}, false});
  const Simulation simulation(scene, graphics.programs.get(), false);
  CHECK(instrument_marks(simulation, {}, std::nullopt, std::nullopt, false).empty());

  std::vector<ToolLoad> loads(3);
  loads[0] = {{0, 15, 0}, {0, 0, 0}, 4, 0};
  loads[2] = {{3, 4, 0}, {0, 0, 0}, 5, 2, 1e-3};
  const std::vector<InstrumentMark> touching = instrument_marks(simulation, loads, std::nullopt, std::nullopt, true);
  REQUIRE(touching.size() == 1);
  CHECK(touching[0].force == 5);
  CHECK((touching[0].at - Vector3d(0.3, 0.16, 0)).norm() < 1e-12);  // between the jaws
  CHECK(!touching[0].commanded);
  CHECK(!touching[0].waits);

  ToolPlace commanded = simulation.tool_places()[1];
  commanded.pose.origin.x() += 0.05;
  const std::vector<InstrumentMark> held = instrument_marks(simulation, loads, 1, commanded, true);
  REQUIRE(held.size() == 2);
  CHECK(!held[0].force);
  CHECK(held[0].at == Vector3d(0, 0.2, 0));
  CHECK(held[0].commanded == Vector3d(0.05, 0.2, 0));
  CHECK(held[0].waits);
  CHECK(!held[1].waits);
}
