// Times of the steps of a replay whose session changed the time step.
#include "sim/replay/replay_time.h"

#include <catch2/catch.hpp>

using namespace fascia;

namespace {

Input time_step(long step, double seconds) {
  SolverSettings settings;
  settings.time_step = seconds;
  return {step, settings};
}

Replay replay_of(std::vector<Input> inputs) {
  Replay replay;
  replay.scene.solver.time_step = 0.5;
  replay.inputs = std::move(inputs);
  return replay;
}

}  // namespace

TEST_CASE("without a change all steps have the length in the scene") {
  const ReplayTime time(replay_of({time_step(3, 0.5), {4, GravityInput{{0, 0, 0}}}}));
  CHECK(time.seconds(0) == 0);
  CHECK(time.seconds(6) == 3);
  CHECK(time.steps(3) == 6);
  CHECK(time.steps(1.2) == 2);  // 1.0 is nearer than 1.5
  CHECK(time.steps(1.3) == 3);
  CHECK(time.time_step(100) == 0.5);
  CHECK(time.longest_step() == 0.5);
}

TEST_CASE("times add up over parts with different steps") {
  // 4 steps of 0.5 s, 8 of 0.25 s, then of 1 s.
  const ReplayTime time(replay_of({time_step(4, 0.25), time_step(12, 0.125), time_step(12, 1)}));
  double sum = 0;
  for (long step = 0; step < 20; ++step) {
    const double expected = step < 4 ? 0.5 : step < 12 ? 0.25 : 1.0;
    CAPTURE(step, sum);
    CHECK(time.time_step(step) == expected);
    CHECK(time.seconds(step) == sum);
    CHECK(time.steps(sum) == step);
    CHECK(time.steps(sum + 0.4 * expected) == step);
    CHECK(time.steps(sum + 0.6 * expected) == step + 1);
    sum += expected;
  }
  CHECK(time.longest_step() == 1);
}

TEST_CASE("a change before the first step belongs to the first part") {
  const ReplayTime time(replay_of({time_step(0, 2), time_step(3, 1)}));
  CHECK(time.time_step(0) == 2);
  CHECK(time.seconds(3) == 6);
  CHECK(time.seconds(5) == 8);
  CHECK(time.longest_step() == 2);
}
