#include "sim/simulation/static_equilibrium.h"

#include <catch2/catch.hpp>

using namespace fascia;

TEST_CASE("what is left of a static solve follows from the fall of its residual") {
  // From 1 to 1e-2 in 10 s; three more decades of the same pace take 15 s.
  CHECK(*seconds_left(1, 1e-2, 1e-5, 10) == Approx(15));
  CHECK(*seconds_left(1e-1, 1e-4, 1e-5, 3) == Approx(1));
  CHECK(!seconds_left(1, 1, 1e-5, 10));  // does not fall
  CHECK(!seconds_left(1, 2, 1e-5, 10));
  CHECK(!seconds_left(1, 1e-6, 1e-5, 10));  // done
  CHECK(!seconds_left(1, 0.1, 0, 10));      // no tolerance
}
