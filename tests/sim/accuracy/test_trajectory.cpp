#include "sim/accuracy/trajectory.h"

#include <catch2/catch.hpp>

using namespace fascia;

TEST_CASE("the error of a run is that of its end and of all its moments, relative to the better run") {
  Trajectory truth, found;
  truth.displacement = {{{3, 0, 0}, {0, 4, 0}}, {{0, 0, 5}, {0, 0, 0}}};
  found.displacement = {{{3, 0, 0}, {0, 4, 3}}, {{0, 0, 5}, {4, 0, 0}}};
  truth.peak_stress = 100;
  found.peak_stress = 80;
  const RunError error = error_of(found, truth);
  CHECK(error.complete);
  CHECK(error.relative == Approx(4.0 / 5));
  CHECK(error.over_run == Approx(5 / std::sqrt(50.0)));
  CHECK(error.peak_stress == Approx(0.2));
}

TEST_CASE("runs of no moments and runs that are equal have no error") {
  CHECK(error_of({}, {}).over_run == 0);
  Trajectory still;
  still.displacement = {{{0, 0, 0}}};
  const RunError error = error_of(still, still);
  CHECK(error.relative == 0);
  CHECK(error.over_run == 0);
  CHECK(error.peak_stress == 0);
}
