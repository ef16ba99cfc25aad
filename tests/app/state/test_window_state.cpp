// What the window shows of its state beyond single numbers.
#include <catch2/catch.hpp>

#include "app/state/window_state.h"

using namespace fascia;

TEST_CASE("the time at which tets turned inside out is kept until all are upright again") {
  Statistics statistics;
  statistics.follow_inverted();
  CHECK_FALSE(statistics.inverted_since);
  const auto at = [&](double time, int inverted) {
    statistics.diagnostics.emplace();
    statistics.diagnostics->time = time;
    statistics.diagnostics->inverted = inverted;
    statistics.follow_inverted();
    return statistics.inverted_since;
  };
  CHECK_FALSE(at(1, 0));
  CHECK(at(2, 3) == 2);
  CHECK(at(3, 5) == 2);
  CHECK_FALSE(at(4, 0));
  CHECK(at(5, 1) == 5);
}
