// The mouse during a replay: it does not release the replay's grabs.
#include <catch2/catch.hpp>

#include "app/session/graphics.h"
#include "app/window/parts/mouse_tool.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

struct Replayed {
  Graphics graphics = open_graphics(headless(), false);
  Session session{graphics, open_scene(source_dir() / "assets/scenes/cube.json"), false};
  Replayed() {
    const std::vector<char> held = session.simulation.model.held();
    GrabInput springs;
    for (std::uint32_t v = 0; v < held.size() && springs.size() < 4; ++v)
      if (!held[v]) springs.push_back({v, Vector3d(0, 0.01, 0), 50});
    session.simulation.play(
        {session.simulation.scene, std::nullopt, {{0, springs}, {2, GrabMove{{{4, Vector3d(0, 0.005, 0)}}}}}, 6});
    session.simulation.step();
  }
};

}  // namespace

TEST_CASE("releasing all grabs that stay does not affect those of a replay") {
  Replayed played;
  Simulation& simulation = played.session.simulation;
  MouseTool mouse;
  mouse.let_go_staying(played.session);
  CHECK(simulation.asked_springs().size() == 4);
  for (int i = 0; i < 3; ++i) simulation.step();
  REQUIRE(simulation.asked_springs().size() == 4);
  CHECK(simulation.asked_springs()[0].target == Vector3d(0, 0.015, 0));
}

TEST_CASE("a replay whose springs were released does not move missing ones") {
  Replayed played;
  Simulation& simulation = played.session.simulation;
  simulation.set_grab({});
  for (int i = 0; i < 3; ++i) simulation.step();
  CHECK(simulation.asked_springs().empty());
  CHECK(simulation.replaying());
}
