#include <catch2/catch.hpp>

#include <cmath>

#include "render/passes/ground.h"

TEST_CASE("grid lines are 1, 2 or 5 times a power of ten apart, four to ten of them per scene radius") {
  for (double radius = 3e-4; radius < 500; radius *= 1.07) {
    const fascia::GridScale scale = fascia::grid_scale(radius);
    const double decade = std::pow(10.0, std::floor(std::log10(scale.spacing * (1 + 1e-9))));
    const double digit = scale.spacing / decade;
    CAPTURE(radius, scale.spacing, scale.strong);
    CHECK((std::abs(digit - 1) < 1e-9 || std::abs(digit - 2) < 1e-9 || std::abs(digit - 5) < 1e-9));
    CHECK(radius / scale.spacing >= 4 - 1e-9);
    CHECK(radius / scale.spacing <= 10 + 1e-9);
    // The spacing of strong lines is also a round number of meters.
    const double strong = scale.spacing * scale.strong / decade;
    CHECK((std::abs(strong - 5) < 1e-9 || std::abs(strong - 10) < 1e-9));
  }
}
