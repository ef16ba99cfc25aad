// When the rest detector considers a body at rest.
#include <catch2/catch.hpp>

#include "sim/model/rest_detector.h"

using namespace fascia;

namespace {

constexpr double kSize = 0.2;  // [m]

Movement movement(double seconds, double way, double speed, double displacement = 0) {
  return {seconds, way, speed, displacement};
}

}  // namespace

TEST_CASE("a body is at rest after a quarter of a second and two checks without movement") {
  const SolverSettings settings;
  RestWatch watch;
  CHECK_FALSE(watch.add(movement(0.1, 0, 0), settings, kSize));
  CHECK_FALSE(watch.add(movement(0.1, 0, 0), settings, kSize));
  CHECK(watch.add(movement(0.1, 0, 0), settings, kSize));
  RestWatch slow;
  CHECK_FALSE(slow.add(movement(1, 0, 0), settings, kSize));
  CHECK(slow.add(movement(1, 0, 0), settings, kSize));
  slow.restart();
  CHECK_FALSE(slow.add(movement(1, 0, 0), settings, kSize));
}

TEST_CASE("a displacement or a speed above solver.rest_speed is movement") {
  const SolverSettings settings;
  const double limit = settings.rest_speed * kSize;  // [m/s]
  const auto rests = [&](const Movement& last) {
    RestWatch watch;
    for (int i = 0; i < 3; ++i) watch.add(movement(1, 0, 0), settings, kSize);
    return watch.add(last, settings, kSize);
  };
  CHECK(rests(movement(1, 0.9 * limit, 0)));
  CHECK_FALSE(rests(movement(1, 1.1 * limit, 0)));
  CHECK(rests(movement(1, 0, 0.9 * limit)));
  CHECK_FALSE(rests(movement(1, 0, 1.1 * limit)));  // the displacement may be zero at a turning point
  // Far from its rest position, float32 does not resolve such small displacements.
  CHECK(rests(movement(1, 1.1 * limit, 0, 1)));
}

TEST_CASE("with a rest speed of 0 nothing is ever at rest") {
  SolverSettings settings;
  settings.rest_speed = 0;
  RestWatch watch;
  for (int i = 0; i < 10; ++i) CHECK_FALSE(watch.add(movement(1, 0, 0), settings, kSize));
}
