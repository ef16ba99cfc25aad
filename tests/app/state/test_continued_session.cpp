#include "app/state/continued_session.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "app/session/open_input.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("a mesh on its own keeps what was guessed about it when its elements or instruments change") {
  Graphics graphics = open_graphics(headless(), false);
  Opened opened = open_file(source_dir() / "assets/meshes/cube.msh");
  Session session(graphics, std::move(opened.scene), std::move(opened.model), false);
  const Model& model = session.simulation.model;
  REQUIRE(model.plan);
  Scene scene = session.simulation.scene;
  scene.bodies[0].elements = ElementOrder::quadratic;
  const auto quadratic = continued_session(graphics, session, scene);
  scene.bodies[0].elements = ElementOrder::linear;
  scene.tools.instruments.push_back({"probe", SphereShape{{0, 0, 0}, 0.01}, {}, {{}}, false});
  scene.tools.instruments[0].path[0].position = {0, 1, 0};
  const auto with_probe = continued_session(graphics, *quadratic, scene);
  for (const Session* changed : {quadratic.get(), with_probe.get()}) {
    const Model& now = changed->simulation.model;
    REQUIRE(now.plan);
    CHECK(now.plan->unit_reason == model.plan->unit_reason);
    CHECK(now.plan->up_reason == model.plan->up_reason);
    CHECK(now.notes == model.notes);
  }
}

TEST_CASE("bodies that lie on each other lie on where an instrument comes") {
  Graphics graphics = open_graphics(headless(), false);
  Opened opened = open_file(source_dir() / "assets/scenes/stack.json");
  Session session(graphics, std::move(opened.scene), std::move(opened.model), false);
  for (int step = 0; step < 90; ++step) session.simulation.step();
  const auto fastest = [](Simulation& simulation) {
    double most = 0;
    for (const Eigen::Vector3d& v : simulation.state().velocity) most = std::max(most, v.norm());
    return most;
  };
  const double before = fastest(session.simulation);
  Scene scene = session.simulation.scene;
  scene.tools.instruments.push_back({"ball", SphereShape{{0, 0, 0}, 0.02}, {}, {{}}, false});
  scene.tools.instruments[0].path[0].position = {0, 1, 0};
  const auto with_ball = continued_session(graphics, session, scene);
  double most = 0;
  for (int step = 0; step < 5; ++step) {
    with_ball->simulation.step();
    most = std::max(most, fastest(with_ball->simulation));
  }
  CAPTURE(before, most);
  CHECK(most < before + 0.01);  // [m/s]
}
