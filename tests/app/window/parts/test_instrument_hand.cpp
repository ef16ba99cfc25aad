// Instruments in the hand of the user, without a window: what drags and wheel command, and how the tool follows.
#include "app/window/parts/instrument_hand.h"

#include <catch2/catch.hpp>

#include "app/session/graphics.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr InstrumentHand::Picture kPicture{400, 400};
constexpr double kRadius = 0.015;

// The cube of 0.1 m seen from the front, with a ball above it, forceps behind the ball, and ground.
struct Desk {
  Graphics graphics = open_graphics(headless(), false);
  std::unique_ptr<Session> session;
  InstrumentHand hand;
  explicit Desk(double half_jaw = 0.01) {
    Scene scene = open_scene(source_dir() / "assets/scenes/cube.json");
    scene.bodies[0].fixed = {LowestSelection{0.02}};
    scene.gravity.setZero();
    scene.camera = CameraSettings{{0, 0.08, 0.5}, {0, 0.08, 0}, {0, 1, 0}, 40};
    scene.tools.ground.emplace();
    scene.tools.ground->height = -1;
    scene.tools.instruments.push_back(
        {"ball", ToolShape(SphereShape{{0, 0, 0}, kRadius}), std::nullopt, {{0, {0, 0.15, 0}, {0, 0, 0}, 0}}, false});
    scene.tools.instruments.push_back(
        {"forceps",
         JawsShape{BoxShape{{half_jaw, -0.04, 0}, {half_jaw, 0.04, 0.01}, 0}, {0, 0, 1}, 40},
         std::nullopt,
         {{0, {0, 0.2, -0.1}, {0, 0, 0}, 0}},
         false});
    session = std::make_unique<Session>(graphics, scene, false);
  }
  Simulation& simulation() { return session->simulation; }
  ToolPlace place(std::size_t tool) { return simulation().tool_places()[tool]; }
  void step(int count = 1) {
    for (int i = 0; i < count; ++i) {
      hand.lead(*session);
      simulation().step();
    }
  }
  void drag(InstrumentHand::Drag how, const Vector2d& from, const Vector2d& to) {
    hand.press(how, from);
    hand.move(to, kPicture, *session);
    hand.release();
  }
  double force_on_tissue(std::size_t tool) {
    simulation().gpu()->request_diagnostics();
    return simulation().gpu()->take_diagnostics(true)->tool_loads[tool].force.norm();
  }
};

constexpr std::size_t kBall = 1, kForceps = 2;  // after the ground

}  // namespace

TEST_CASE("the next instrument, the one after, none; and the one under the mouse") {
  Desk desk;
  desk.hand.pick_next(desk.simulation());
  CHECK(desk.hand.picked() == kBall);
  desk.hand.pick_next(desk.simulation());
  CHECK(desk.hand.picked() == kForceps);
  desk.hand.pick_next(desk.simulation());
  CHECK(!desk.hand.picked());

  const double down = 0.07 / desk.session->camera.pixel_size({0, 0.15, 0}, 400, 400);
  CHECK(InstrumentHand::at({200, 200 - down}, kPicture, *desk.session) == kBall);
  CHECK(!InstrumentHand::at({20, 20}, kPicture, *desk.session));
  CHECK(!InstrumentHand::at({200, 230}, kPicture, *desk.session));  // tissue
}

TEST_CASE("an instrument that was only picked stays on its path, and one that was moved follows the mouse") {
  Desk desk;
  desk.hand.pick(kBall);
  desk.step();
  CHECK(desk.simulation().led_tools().empty());
  CHECK(desk.hand.gap(*desk.session) == 0);

  const Vector3d before = desk.place(kBall).pose.origin;
  const double pixel = desk.session->camera.pixel_size(before, 400, 400);
  desk.drag(InstrumentHand::Drag::shift, {200, 100}, {260, 70});
  CHECK(desk.hand.gap(*desk.session) == Approx(pixel * std::hypot(60, 30)).epsilon(1e-3));
  desk.step(40);
  const Vector3d way = desk.place(kBall).pose.origin - before;
  CHECK(way.x() == Approx(60 * pixel).epsilon(1e-3));
  CHECK(way.y() == Approx(30 * pixel).epsilon(1e-3));
  CHECK(std::abs(way.z()) < 1e-9);
  CHECK(desk.hand.gap(*desk.session) == 0);

  desk.hand.scroll(3, *desk.session);
  desk.step(40);
  CHECK(desk.place(kBall).pose.origin.z() < before.z() - 1e-3);
  CHECK(desk.place(kForceps).pose.origin == Vector3d(0, 0.2, -0.1));
}

TEST_CASE("right drags turn an instrument about its origin, as the mouse goes") {
  Desk desk;
  desk.hand.pick(kForceps);
  const Vector3d origin = desk.place(kForceps).pose.origin;
  desk.drag(InstrumentHand::Drag::turn, {200, 100}, {300, 100});  // a quarter of the picture: 45 degrees
  desk.step();
  CHECK((desk.place(kForceps).pose.origin - origin).norm() < 1e-12);
  const Vector3d front = desk.place(kForceps).pose.axes.col(2);
  CHECK(front.x() == Approx(std::sqrt(0.5)));
  CHECK(front.z() == Approx(std::sqrt(0.5)));
}

TEST_CASE("jaws close and open smoothly while a key is held, and stay as they are when it is released") {
  Desk desk;
  desk.hand.pick(kForceps);
  desk.hand.move_jaws(1, *desk.session);
  double before = 0;
  for (int i = 0; i < 10; ++i) {
    desk.step();
    const double grip = desk.place(kForceps).grip;
    CHECK(grip > before);
    CHECK(grip < before + 0.01);
    before = grip;
  }
  desk.hand.stop_jaws(*desk.session);
  desk.step(5);
  CHECK(desk.place(kForceps).grip == before);
  desk.hand.move_jaws(1, *desk.session);
  desk.step(2);
  before = desk.place(kForceps).grip;
  desk.hand.pick(std::nullopt);
  desk.step(5);
  CHECK(desk.place(kForceps).grip == before);
  desk.hand.pick(kForceps);
  desk.hand.move_jaws(1, *desk.session);
  desk.step(125);
  CHECK(desk.place(kForceps).grip == 1);
  desk.hand.move_jaws(0, *desk.session);
  desk.step(125);
  CHECK(desk.place(kForceps).grip == 0);
}

TEST_CASE("jaws that are behind their command stop where they are", "[contact]") {
  Desk desk(0.0005);  // so thin that near tissue they close more slowly than commanded
  desk.hand.pick(kForceps);
  desk.hand.scroll(-0.1 / (0.01 * desk.session->look.radius), *desk.session);
  const double pixel = desk.session->camera.pixel_size({0, 0.2, 0}, 400, 400);
  desk.drag(InstrumentHand::Drag::shift, {200, 100}, {200, 100 + 0.03 / pixel});  // tips in the upper face
  desk.step(300);
  REQUIRE(desk.hand.gap(*desk.session) == 0);
  desk.hand.move_jaws(1, *desk.session);
  desk.step(20);
  REQUIRE(desk.hand.gap(*desk.session) > 0);
  const double grip = desk.place(kForceps).grip;
  CHECK(grip > 0.03);
  CHECK(grip < 0.15);
  desk.hand.stop_jaws(*desk.session);
  desk.step(20);
  CHECK(desk.place(kForceps).grip == grip);
  CHECK(desk.hand.gap(*desk.session) == 0);
}

TEST_CASE("a jump of the mouse through tissue presses on it instead, with a gap that closes step by step",
          "[contact]") {
  Desk desk;
  desk.hand.pick(kBall);
  const double top = 0.1 + kRadius, pixel = desk.session->camera.pixel_size({0, 0.15, 0}, 400, 400);
  desk.drag(InstrumentHand::Drag::shift, {200, 100}, {200, 100 + 0.06 / pixel});  // its middle to 0.01 m below the face
  desk.step();
  CHECK(desk.place(kBall).pose.origin.y() > top);
  CHECK(desk.hand.gap(*desk.session) > 0.03);
  double before = desk.place(kBall).pose.origin.y();
  for (int i = 0; i < 30; ++i) {
    desk.step();
    const double now = desk.place(kBall).pose.origin.y();
    CHECK(before - now <= kRadius / 4 + 1e-9);
    before = now;
  }
  CHECK(desk.hand.gap(*desk.session) == 0);
  const double force = desk.force_on_tissue(kBall);
  CAPTURE(force);
  CHECK(force > 0.01);
  desk.hand.rest();
  desk.step(3);
  CHECK(desk.place(kBall).pose.origin.y() == before);
}
// Nearly incompressible tissue that is crushed keeps its volume.
TEST_CASE("a thin rod that is pressed on waits where it has crushed the tissue before it, and is led back freely",
          "[contact]") {
  const double poisson_ratio = GENERATE(0.4, 0.49);
  CAPTURE(poisson_ratio);
  Graphics graphics = open_graphics(headless(), false);
  Scene scene = open_scene(source_dir() / "assets/scenes/palpation.json");
  scene.bodies[0].material.poisson_ratio = poisson_ratio;
  scene.tools.instruments[0].path = {{0, {-0.05, 0.082, 0}, {0, 0, 0}, 0}};
  scene.camera = CameraSettings{{0, 0.03, 0.5}, {0, 0.03, 0}, {0, 1, 0}, 40};
  Session session(graphics, scene, false);
  InstrumentHand hand;
  hand.pick(0);
  const auto place = [&] { return session.simulation.tool_places()[0].pose.origin; };
  const auto drag = [&](double right, double down) {
    const double pixel = session.camera.pixel_size(place(), 400, 400);
    hand.press(InstrumentHand::Drag::shift, {200, 200});
    hand.move({200 + right / pixel, 200 + down / pixel}, kPicture, session);
    hand.release();
  };
  const auto measure = [&] {
    session.simulation.gpu()->request_diagnostics();
    return *session.simulation.gpu()->take_diagnostics(true);
  };
  const auto steps = [&](int count) {
    for (int i = 0; i < count; ++i) {
      hand.lead(session);
      session.simulation.step();
    }
  };
  double pressed = 0;
  for (int i = 0; i < 50 && !hand.waits(); ++i) {
    drag(0, 0.002);
    steps(2);
    pressed = std::max(pressed, measure().tool_loads[0].normal);
  }
  REQUIRE(hand.waits());
  const Vector3d stop = place();
  CAPTURE(stop.y(), pressed);
  CHECK(stop.y() < 0.06);
  CHECK(stop.y() > 0.02);
  drag(0, 0.05);
  steps(60);
  CHECK(hand.waits());
  CHECK(hand.gap(session) > 0.045);
  const Diagnostics waiting = measure();
  CAPTURE(waiting.tool_loads[0].normal);
  CHECK(stop.y() - place().y() < 0.005);
  CHECK(waiting.tool_loads[0].normal > 0.6 * pressed);

  SECTION("out") {
    const double before = place().y();
    drag(0, -0.1);
    steps(60);
    CHECK(!hand.waits());
    CHECK(place().y() > before + 0.02);
  }
  SECTION("aside, along what it has crushed") {
    const double before = place().x();
    drag(0.1, -0.05);  // where it waits in depth
    steps(120);
    CHECK(place().x() > before + 0.02);
  }
}
