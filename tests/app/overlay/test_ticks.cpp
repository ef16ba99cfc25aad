// Ticks of an axis: at round numbers, and at both ends if these are round.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "app/ui/ticks.h"

using namespace fascia;

TEST_CASE("both ends of a range have a tick if they are multiples of the step, also as float32", "[ticks]") {
  const bool rounded = GENERATE(true, false);
  int ends = 0;
  const auto check = [&](double low, double high) {
    const Ticks ticks =
        linear_ticks(rounded ? static_cast<float>(low) : low, rounded ? static_cast<float>(high) : high, 5);
    CAPTURE(rounded, low, high, ticks.values);
    REQUIRE(ticks.values.size() >= 2);
    REQUIRE(ticks.values.size() <= 6);
    CHECK(std::is_sorted(ticks.values.begin(), ticks.values.end()));
    const double step = ticks.values[1] - ticks.values[0], allowed = 1e-6 * std::max(std::abs(low), std::abs(high));
    const double leading = step / std::pow(10.0, std::floor(std::log10(step * (1 + 1e-6))));
    CAPTURE(step, leading);
    CHECK(std::min({std::abs(leading - 1), std::abs(leading - 2), std::abs(leading - 5)}) < 1e-3);
    CHECK(ticks.values.front() >= low - allowed);
    CHECK(ticks.values.back() <= high + allowed);
    const auto round = [&](double end) { return std::abs(end / step - std::round(end / step)) < 1e-6; };
    if (round(low)) CHECK(std::abs(ticks.values.front() - low) <= allowed);
    if (round(high)) CHECK(std::abs(ticks.values.back() - high) <= allowed);
    // There is no gap at an end that is large enough for another tick.
    CHECK(ticks.values.front() - low < step * (1 - 1e-6) + allowed);
    CHECK(high - ticks.values.back() < step * (1 - 1e-6) + allowed);
    ends += round(low) + round(high);
  };
  for (int decade = -9; decade <= 9; ++decade)
    for (const double leading : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0}) {
      const double high = leading * std::pow(10.0, decade);
      check(0, high);
      check(-high, high);
      check(-high, 0);
      check(high / 10, high);
      check(high, 3 * high);
    }
  for (const double reach : {0.5, 0.2, 0.1, 0.05, 0.01, 0.002, 1e-3, 1e-4, 1e-5})
    check(1 - reach, 1 + reach);  // of the volume ratio
  CAPTURE(ends);
  CHECK(ends > 1000);
}
