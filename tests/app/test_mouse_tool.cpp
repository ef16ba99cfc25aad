// The mouse beside a replay: what the replay holds is not the mouse's to let go of. And hands that wait until they may pull.
#include <catch2/catch.hpp>

#include "app/graphics.h"
#include "app/mouse_tool.h"
#include "tests/app/headless.h"
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
    session.simulation.play({session.simulation.scene, std::nullopt, {{0, springs}, {2, GrabMove{{{4, Vector3d(0, 0.005, 0)}}}}}, 6});
    session.simulation.step();
  }
};

}  // namespace

TEST_CASE("letting go of all hands that stay leaves those of a replay alone") {
  Replayed played;
  Simulation& simulation = played.session.simulation;
  MouseTool mouse;
  mouse.let_go_staying(played.session);
  CHECK(simulation.asked_springs().size() == 4);
  for (int i = 0; i < 3; ++i) simulation.step();
  REQUIRE(simulation.asked_springs().size() == 4);
  CHECK(simulation.asked_springs()[0].target == Vector3d(0, 0.015, 0));
}

TEST_CASE("a replay whose springs were let go of moves none that are not there") {
  Replayed played;
  Simulation& simulation = played.session.simulation;
  simulation.set_grab({});
  for (int i = 0; i < 3; ++i) simulation.step();
  CHECK(simulation.asked_springs().empty());
  CHECK(simulation.replaying());
}

TEST_CASE("hands that wait give the simulation nothing, and then pull the tissue from where it has moved to") {
  Graphics graphics = open_graphics(headless(), false);
  Session session(graphics, open_scene(source_dir() / "assets/scenes/cube.json"), false);
  std::vector<Input> heard;
  session.simulation.set_listener([&](const Input& input) { heard.push_back(input); });
  const MouseTool::Picture picture{200, 200};
  const auto step = [&](MouseTool& mouse) {
    mouse.pull(session);
    session.simulation.step();
  };
  MouseTool mouse;
  const auto press = [&](const Eigen::Vector2d& at) { mouse.press(MouseTool::Button::left, {}, at, picture, session, {}); };
  press({100, 100});
  REQUIRE(mouse.hands().following());
  mouse.wait(true, session);
  mouse.move({120, 80}, picture, session);
  for (int i = 0; i < 5; ++i) step(mouse);
  mouse.stay();
  press({100, 110});
  mouse.release(MouseTool::Button::left, {}, session, {});
  mouse.let_go_staying(session);
  press({100, 100});
  REQUIRE(mouse.hands().following());
  const Vector3d taken = mouse.hands().following()->anchor();
  mouse.move({120, 80}, picture, session);
  for (int i = 0; i < 5; ++i) step(mouse);
  CHECK(heard.empty());
  CHECK(session.simulation.springs().empty());

  const reference::State before = session.simulation.state();
  mouse.wait(false, session);
  CHECK(heard.empty());
  CHECK((mouse.hands().following()->anchor() - taken).norm() > 1e-6);  // it has sunk under its weight
  step(mouse);
  REQUIRE(heard.size() == 1);
  REQUIRE(!session.simulation.springs().empty());
  const double stride = 0.1 * session.look.radius;  // Grab's, of a step
  for (const GrabSpring& spring : session.simulation.springs())
    CHECK((spring.target - before.displacement[spring.vertex]).norm() <= stride);
}
