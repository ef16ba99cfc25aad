// The fixed-step accumulator, driven by simulated clocks.
#include <catch2/catch.hpp>

#include "app/window/parts/real_time_clock.h"

using fascia::Pacing;

TEST_CASE("frames as long as a step make one step each, in spite of jitter") {
  Pacing pacing;
  const double dt = 1.0 / 60;
  for (int frame = 0; frame < 600; ++frame) {
    CAPTURE(frame);
    const double jitter = 0.3 * dt * ((frame % 3) - 1);  // -0.3, 0, 0.3 of a step: the sum stays within half a step
    CHECK(pacing.advance(dt + jitter, dt, 1e-3) == 1);
  }
  CHECK(pacing.speed() == Approx(1).margin(0.01));
}

TEST_CASE("steps follow real time at any frame rate") {
  for (const double frame_time : {1.0 / 240, 1.0 / 144, 1.0 / 60, 1.0 / 24, 1.0 / 13}) {
    CAPTURE(frame_time);
    Pacing pacing;
    const double dt = 1.0 / 60;
    double real = 0;
    long steps = 0;
    for (int frame = 0; frame < 1000; ++frame) {
      real += frame_time;
      steps += pacing.advance(frame_time, dt, 1e-4);
    }
    CHECK(std::abs(static_cast<double>(steps) * dt - real) <= dt);  // no time was dropped
    CHECK(pacing.keeps_pace());
  }
}

TEST_CASE("a step that costs more than it simulates slows the scene, and the speed shows by how much") {
  Pacing pacing;
  const double dt = 1.0 / 60, cost = 0.04;
  for (int frame = 0; frame < 200; ++frame) CHECK(pacing.advance(cost, dt, cost) <= 1);
  CHECK(pacing.speed() == Approx(dt / cost).epsilon(0.05));
  CHECK_FALSE(pacing.keeps_pace());
  // Time that did not fit is dropped: when steps become fast again, they do not catch up.
  int steps = 0;
  for (int frame = 0; frame < 60; ++frame) steps += pacing.advance(dt, dt, 1e-4);
  CHECK(steps >= 59);
  CHECK(steps <= 61);
}

TEST_CASE("slow steps are forgotten while nothing is solved, and steps continue as before") {
  Pacing pacing, other;
  const double dt = 1.0 / 60, cost = 0.04;
  for (int frame = 0; frame < 200; ++frame) pacing.advance(cost, dt, cost), other.advance(cost, dt, cost);
  REQUIRE_FALSE(pacing.keeps_pace());
  for (int frame = 0; frame < 100; ++frame) {
    pacing.forget_speed();
    CAPTURE(frame, pacing.speed());
    CHECK(pacing.keeps_pace());
    CHECK(pacing.speed() == 1);
    CHECK(pacing.advance(dt / 4, dt, cost) ==
          other.advance(dt / 4, dt, cost));  // also if frames are shorter than steps
  }
}

TEST_CASE("small time steps get as many steps as fit into the frame") {
  Pacing pacing;
  const double dt = 1e-4;
  CHECK(pacing.advance(1.0 / 60, dt, 1e-5) == 167);  // 166.7 plus the initial half step
  CHECK(pacing.advance(1.0 / 60, dt, 1e-2) == 3);    // 30 ms of a frame are for steps
  CHECK(pacing.advance(1.0 / 60, dt, 0) == 1);       // cost not measured yet
}

TEST_CASE("slow pictures do not slow the tissue as long as a step is faster than real time") {
  const double dt = 1.0 / 60, picture = 0.045, cost = 0.010;
  Pacing pacing;
  double frame_time = picture;
  for (int frame = 0; frame < 200; ++frame) frame_time = picture + cost * pacing.advance(frame_time, dt, cost);
  CHECK(pacing.speed() == Approx(1).margin(0.05));
  CHECK(frame_time == Approx(picture / (1 - cost / dt)).margin(cost));  // as many steps as real time asks for, no more
}

TEST_CASE("steps of a frame are limited where nothing keeps pace, so that frames do not grow") {
  const double dt = 1.0 / 60, picture = 0.065, cost = 0.020;
  Pacing pacing;
  double frame_time = picture;
  int steps = 0;
  for (int frame = 0; frame < 200; ++frame) {
    steps = pacing.advance(frame_time, dt, cost);
    frame_time = picture + cost * steps;
    CHECK(frame_time <= picture + 0.12);
  }
  CHECK(steps == 6);
  CHECK(pacing.speed() == Approx(6 * dt / (picture + 6 * cost)).epsilon(0.05));
  CHECK_FALSE(pacing.keeps_pace());
}

TEST_CASE("the speed counts all of the time that slow steps take") {
  Pacing pacing;
  const double dt = 1.0 / 60, cost = 2.0;
  for (int frame = 0; frame < 10; ++frame) pacing.advance(cost, dt, cost);
  CAPTURE(pacing.speed());
  CHECK(pacing.speed() == Approx(dt / cost).epsilon(0.1));
}

TEST_CASE("a long gap is not made up for") {
  Pacing pacing;
  const double dt = 1.0 / 60;
  int steps = pacing.advance(30.0, dt, 1e-3);
  CHECK(steps <= 16);
  steps = pacing.advance(dt, dt, 1e-3);
  CHECK(steps <= 2);
  pacing.restart();
  CHECK(pacing.speed() == 1);
  CHECK(pacing.advance(0, dt, 1e-3) == 0);
}
