// The spread of measured times.
#include "app/bench/timing.h"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace fascia;

TEST_CASE("a spread is the median and the first and last deciles") {
  std::vector<double> values;
  for (int i = 0; i <= 100; ++i) values.push_back((i * 37) % 101);  // 0 to 100, shuffled
  const Spread spread = spread_of(values);
  CHECK(spread.median == 50);
  CHECK(spread.low == 10);
  CHECK(spread.high == 90);
}

TEST_CASE("one value is its own spread, an outlier does not move the median, and no values have no spread") {
  const Spread one = spread_of({7});
  CHECK(one.median == 7);
  CHECK(one.low == 7);
  CHECK(one.high == 7);
  CHECK(spread_of({3, 1000, 2}).median == 3);
  CHECK(spread_of({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 1e6}).high == 10);
  CHECK(spread_of({}).median == 0);
}
