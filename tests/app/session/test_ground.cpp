// The drawn ground: at the foot of what stands, and below what hangs, however far it sinks.
// Covers: session, sim/gpu/readback/lowest_point
#include <catch2/catch.hpp>

#include "app/session/session.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

constexpr double kSide = 0.08;  // of the cube, around 0 along x and z

Scene cube(const std::string& fixed) {
  return open_scene(source_dir() / "assets/scenes/cube.json", {"fixed=" + fixed});
}

double lowest(const Session& session) {
  const Model& model = session.simulation.model;
  const State state = session.simulation.state();
  double y = 1e300;
  for (const Tet& t : model.tets)
    for (const std::uint32_t v : t) y = std::min(y, model.rest_positions[v].y() + state.displacement[v].y());
  return y;
}

}  // namespace

TEST_CASE("a body that is held at its foot stands on the ground") {
  Graphics graphics = open_graphics(headless(), false);
  const Session session(graphics, cube(R"([{"lowest": 0.02}])"), false);
  CHECK(session.look.ground_height == Approx(lowest(session)).margin(1e-7));
}

TEST_CASE("the ground gives way to a body that sinks, and returns with the start") {
  Graphics graphics = open_graphics(headless(), false);
  Session session(graphics, cube(R"([{"highest": 0.02}])"), false);
  const double begin = session.look.ground_height;
  CHECK(begin < lowest(session) - 0.2 * session.look.radius);
  session.settle_ground();
  CHECK(session.look.ground_height == begin);

  State sunk = session.simulation.state();
  for (Eigen::Vector3d& u : sunk.displacement) u.y() -= kSide;
  session.simulation.go_on_from(sunk);
  session.settle_ground();
  CHECK(session.look.ground_height == Approx(lowest(session)).margin(1e-7));
  CHECK(session.look.ground_height < begin);

  session.follow_ground();  // without waiting: at the latest in the next picture
  gl::Finish();
  session.follow_ground();
  CHECK(session.look.ground_height == Approx(lowest(session)).margin(1e-7));

  // The body returns, and with it the ground, but only when asked to: it does not follow every swing.
  State back = sunk;
  for (Eigen::Vector3d& u : back.displacement) u.setZero();
  session.simulation.go_on_from(back);
  session.settle_ground();
  CHECK(session.look.ground_height < begin);
  session.lift_ground();
  CHECK(session.look.ground_height == begin);

  session.forget_ground();
  CHECK(session.look.ground_height == begin);
  DisplaySettings display = session.display();
  display.ground = false;
  session.set_display(display);
  session.settle_ground();
  CHECK(session.look.ground_height == begin);  // not drawn, so not measured
}

TEST_CASE("bodies that have left the view are framed with their way back") {
  Graphics graphics = open_graphics(headless(), false);
  Scene scene = cube(R"([{"highest": 0.02}])");
  scene.camera.reset();
  Session session(graphics, scene, false);
  const Camera before = session.camera;
  session.frame_with_motion();
  CHECK(session.camera.eye == before.eye);
  State sunk = session.simulation.state();
  for (Eigen::Vector3d& u : sunk.displacement) u.y() -= 4 * kSide;
  session.simulation.go_on_from(sunk);
  session.frame_with_motion();
  CHECK(session.camera.target.y() < before.target.y() - kSide);
  CHECK((session.camera.eye - session.camera.target).norm() > 1.5 * (before.eye - before.target).norm());
}
