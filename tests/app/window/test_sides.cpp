// The side of a comparison that the panels show, the side that the mouse acts on, and the actions of the buttons.
#include <catch2/catch.hpp>

#include "tests/support/headless_stage.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("without a comparison the open session is both sides") {
  HeadlessStage desk;
  Sides& sides = desk.sides;
  int exchanged = 0;
  for (const CompareAsk ask : {CompareAsk::edit_b, CompareAsk::copy_a, CompareAsk::swap, CompareAsk::keep_b})
    sides.carry_out(ask, [&](const auto&) { ++exchanged; });
  CHECK(exchanged == 0);
  CHECK(sides.split() == nullptr);
  CHECK(sides.second() == nullptr);
  CHECK(&sides.tuned() == desk.stage.session.get());
  CHECK(&sides.held() == desk.stage.session.get());
  Eigen::Vector2d at(700, 300);
  const MouseTool::Picture picture = sides.to_side(at, true);
  CHECK(at == Eigen::Vector2d(700, 300));
  CHECK(picture.width == HeadlessStage::kWidth);
  CHECK_FALSE(sides.grab_in_b());
}

TEST_CASE("each side has its own history, without the changes by a replay at A") {
  HeadlessStage desk;
  Sides& sides = desk.sides;
  WindowState& state = desk.stage.state;
  const auto follow = [&] { state.history.follow(tunables_of(sides.tuned(), state.grab)); };
  desk.compare(CompareAsk::open_or_close);
  REQUIRE(sides.split() != nullptr);
  CHECK(state.comparing);
  CHECK(state.editing_b);
  CHECK(&sides.tuned() == sides.second());
  set_iterations(sides.tuned(), 7);
  follow();
  CHECK(state.history.entries().size() == 1);

  set_iterations(*desk.stage.session, 5);
  sides.accept_tunables_of_a();
  desk.compare(CompareAsk::edit_a);
  CHECK(&sides.tuned() == desk.stage.session.get());
  follow();
  CHECK(state.history.entries().empty());
  desk.compare(CompareAsk::edit_b);
  CHECK(state.history.entries().size() == 1);

  desk.compare(CompareAsk::open_or_close);
  CHECK(sides.split() == nullptr);
  CHECK_FALSE(state.comparing);
  CHECK_FALSE(state.editing_b);
  CHECK(state.history.entries().empty());
  CHECK(iterations_of(*desk.stage.session) == 5);
}

TEST_CASE("sides are copied and swapped, and B is kept; another session in the place of A is an exchange") {
  HeadlessStage desk;
  Sides& sides = desk.sides;
  const int opened = iterations_of(*desk.stage.session);
  int exchanged = 0;
  const auto ask = [&](CompareAsk what) {
    sides.carry_out(what, [&](const auto& change) {
      ++exchanged;
      change();
    });
  };
  ask(CompareAsk::open_or_close);
  set_iterations(sides.tuned(), 7);
  CHECK(exchanged == 0);
  const bool swaps = GENERATE(true, false);
  if (swaps) {
    ask(CompareAsk::swap);
    CHECK(exchanged == 1);
    CHECK(iterations_of(*desk.stage.session) == 7);
    CHECK(iterations_of(*sides.second()) == opened);
    ask(CompareAsk::copy_a);
    CHECK(exchanged == 1);
    CHECK(iterations_of(*sides.second()) == 7);
  } else {
    ask(CompareAsk::keep_b);
    CHECK(exchanged == 1);
    CHECK(iterations_of(*desk.stage.session) == 7);
    CHECK(sides.split() == nullptr);
    CHECK_FALSE(desk.stage.state.comparing);
    CHECK_FALSE(desk.stage.state.editing_b);
  }
}

TEST_CASE("the mouse acts on the side that it pressed until it presses again, and both sides look alike") {
  HeadlessStage desk;
  Sides& sides = desk.sides;
  desk.compare(CompareAsk::open_or_close);
  const auto areas = SplitView::areas(HeadlessStage::kWidth, desk.stage.margins());
  const auto point = [&](double x, bool press) {
    Eigen::Vector2d at(x, 300);
    const MouseTool::Picture picture = sides.to_side(at, press);
    CHECK(picture.width == areas[sides.grab_in_b() ? 1 : 0].width);
    CHECK(picture.height == HeadlessStage::kHeight);
    return at.x();
  };
  CHECK(point(areas[1].x + 20, false) == areas[1].x + 20 - areas[0].x);
  CHECK(sides.points_at_b());
  CHECK_FALSE(sides.grab_in_b());
  CHECK(point(areas[1].x + 20, true) == 20);
  CHECK(sides.grab_in_b());
  CHECK(&sides.held() == sides.second());
  CHECK(point(areas[0].x, false) == areas[0].x - areas[1].x);
  CHECK(sides.grab_in_b());

  sides.held().camera.zoom(0.5);
  sides.after_mouse();
  CHECK(desk.stage.session->camera.eye == sides.held().camera.eye);
  point(areas[0].x, true);
  CHECK(&sides.held() == desk.stage.session.get());
}

TEST_CASE("the steps of a comparison are those of both sides, which sleep and start again together") {
  HeadlessStage desk;
  Sides& sides = desk.sides;
  desk.compare(CompareAsk::open_or_close);
  for (int i = 0; i < 2; ++i) sides.step();
  CHECK(desk.stage.simulation().time() > 0);
  CHECK(sides.second()->simulation.time() == desk.stage.simulation().time());
  sides.reset();
  CHECK(desk.stage.simulation().time() == 0);
  CHECK(sides.second()->simulation.time() == 0);
}
