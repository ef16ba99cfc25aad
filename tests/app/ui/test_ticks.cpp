// Ticks of an axis: at round numbers, and at both ends if the ends are round.
#include "app/ui/ticks.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>

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
    // The gap at an end is too small for another tick.
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

TEST_CASE("axes have round ticks, not too many, with enough digits to differ") {
  for (const auto& [low, high] : {std::pair{0.0, 1.0},
                                  {-3.7e-5, 8.1e-5},
                                  {0.99991, 1.00012},
                                  {12345.0, 12399.0},
                                  {-2e9, 1e3},
                                  {-4.9, 4.9},
                                  {0.01, 0.98},
                                  {4, 14.9}})
    for (const int most : {2, 4, 9}) {
      CAPTURE(low, high, most);
      const Ticks ticks = linear_ticks(low, high, most);
      REQUIRE(!ticks.values.empty());
      CHECK(ticks.values.size() <= static_cast<std::size_t>(std::max(most + 1, 5)));
      CHECK(ticks.values.size() >= 2);
      CHECK(ticks.values.front() >= low - 1e-9 * (high - low));
      CHECK(ticks.values.back() <= high + 1e-9 * (high - low));
      for (std::size_t i = 0; i + 1 < ticks.values.size(); ++i) {
        char a[32], b[32];
        std::snprintf(a, sizeof a, "%.*g", ticks.digits, ticks.values[i]);
        std::snprintf(b, sizeof b, "%.*g", ticks.digits, ticks.values[i + 1]);
        CHECK(std::string(a) != b);
      }
      const double step = ticks.values[1] - ticks.values[0],
                   digit = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
      CAPTURE(step);
      CHECK((std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 5) < 1e-6));
    }
  CHECK(decade_ticks(1e-6, 1, 4).values == std::vector<double>{1e-6, 1e-4, 1e-2, 1});
  CHECK(decade_ticks(2e-3, 5e-3, 4).values.empty());
}

TEST_CASE("an empty range has one tick") {
  CHECK(linear_ticks(3, 3, 5).values == std::vector<double>{3});
  CHECK(linear_ticks(3, 2, 5).values == std::vector<double>{3});
}

TEST_CASE("decades have ticks at intervals that fit, from the first decade on") {
  CHECK(decade_ticks(1, 1000, 9).values == std::vector<double>{1, 10, 100, 1000});
  CHECK(decade_ticks(0.5, 2000, 9).values == std::vector<double>{1, 10, 100, 1000});
  for (int most = 2; most <= 8; ++most)
    for (int last = 1; last <= 20; ++last) {
      const Ticks ticks = decade_ticks(1, std::pow(10.0, last), most);
      CAPTURE(most, last, ticks.values);
      CHECK(ticks.values.size() <= static_cast<std::size_t>(most));
      CHECK(ticks.values.front() == 1);
    }
}
