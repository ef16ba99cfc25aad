// The latest values of a measurement, compared with a list of all values.
#include "app/ui/recent_values.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

using namespace fascia;

TEST_CASE("without values there is no median") {
  const RecentValues values;
  CHECK(values.count() == 0);
  CHECK(values.latest() == 0);
  CHECK(values.median() == 0);
}

TEST_CASE("the latest two hundred stay, the oldest first, and the median is that of the latest thirty") {
  RecentValues values;
  std::vector<double> all;
  for (int i = 0; i < 1000; ++i) {
    all.push_back((i * 7919) % 1009);
    values.add(all.back());
    const std::size_t kept = std::min<std::size_t>(all.size(), 200), first = all.size() - kept;
    CAPTURE(i, kept);
    REQUIRE(values.count() == static_cast<int>(kept));
    CHECK(values.latest() == all.back());
    CHECK(values.at(0) == static_cast<float>(all[first]));
    CHECK(values.at(static_cast<int>(kept) / 2) == static_cast<float>(all[first + kept / 2]));
    CHECK(values.at(static_cast<int>(kept) - 1) == static_cast<float>(all.back()));
    // Half of the thirty are at or below it, half at or above.
    const double median = values.median();
    const std::size_t recent = std::min<std::size_t>(all.size(), 30);
    const auto begin = all.end() - static_cast<std::ptrdiff_t>(recent);
    const auto below = std::count_if(begin, all.end(), [&](double x) { return x <= median; });
    const auto above = std::count_if(begin, all.end(), [&](double x) { return x >= median; });
    CAPTURE(median, below, above);
    CHECK(2 * below >= static_cast<std::ptrdiff_t>(recent));
    CHECK(2 * above >= static_cast<std::ptrdiff_t>(recent));
  }
}
