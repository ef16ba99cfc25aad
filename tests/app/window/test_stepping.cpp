// The steps that a window makes in a frame.
#include <catch2/catch.hpp>

#include "app/window/stepping.h"
#include "tests/support/headless_stage.h"

using namespace fascia;
using namespace fascia::test;

namespace {

struct SteppingDesk : HeadlessStage {
  Stepping stepping{graphics, overlay, stage, sides};
  SteppingDesk() {  // compiles the kernels
    for (int i = 0; i < 2; ++i) stage.simulation().step();
  }
  double time_step() const { return stage.simulation().scene.solver.time_step; }
};

}  // namespace

TEST_CASE("a paused window makes the requested steps, one at a time") {
  SteppingDesk desk;
  desk.stage.state.paused = true;
  CHECK(desk.stepping.still());
  desk.stage.diagnose = false;
  desk.stepping.advance(1, false);
  CHECK(desk.stepping.simulated() == 0);
  CHECK_FALSE(desk.stage.diagnose);
  desk.stepping.advance(1, true);
  CHECK(desk.stepping.simulated() == desk.time_step());
  CHECK(desk.stage.diagnose);
  CHECK(desk.stepping.stats().steps == 1);
  CHECK(desk.stage.state.statistics.steps == 1);
}

TEST_CASE("a window with a limit of steps makes exactly that number") {
  SteppingDesk desk;
  desk.stepping.limit(3);
  for (int i = 0; i < 6; ++i) {
    CHECK(desk.stepping.done() == (i >= 3));
    desk.stepping.advance(desk.time_step(), false);
  }
  CHECK(desk.stepping.stats().steps == 3);
  CHECK(desk.stepping.simulated() == 0);
}

TEST_CASE("a replay gets no steps beyond its end, and follows the user's pace") {
  SteppingDesk desk;
  Simulation& simulation = desk.stage.simulation();
  REQUIRE_FALSE(simulation.awaits_inputs());
  simulation.play({simulation.scene, std::nullopt, {}, 2});
  CHECK(simulation.awaits_inputs());  // so that it goes on where tissue falls asleep in it
  desk.stage.state.statistics.step_ms = 0.01;
  desk.stage.state.replay_speed = 4;
  desk.stepping.advance(3 * desk.time_step(), false);
  CHECK(desk.stepping.stats().steps == 2);
  CHECK_FALSE(simulation.replaying());
  CHECK_FALSE(simulation.awaits_inputs());
}
