#include "sim/bare_mesh/foot.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace fascia;

using Eigen::Vector2d;

TEST_CASE("a square foot tips over its nearest edge, a skew one over its nearest side") {
  const std::vector<Vector2d> square = {{-1, -1}, {1, -1}, {0, 0}, {1, 1}, {-1, 1}, {0, 1}, {1, 1}};
  CHECK(stability(square, {0, 0}, 2) == Approx(0.5));
  CHECK(stability(square, {0.75, 0}, 2) == Approx(0.125));
  CHECK(stability(square, {1.5, 0}, 2) == Approx(-0.25));
  CHECK(stability({{0, 0}, {1, 0}, {0, 1}}, {0, 0.25}, 1) == Approx(0).margin(1e-15));
  CHECK(stability({{0, 0}, {1, 0}, {0, 1}}, {0.25, 0.25}, 1) == Approx(0.25));
}

TEST_CASE("points and lines carry nothing") {
  CHECK(stability({}, {0, 0}, 1) < 0);
  CHECK(stability({{0, 0}, {1, 0}}, {0.5, 0}, 1) < 0);
  CHECK(stability({{0, 0}, {1, 0}, {2, 0}, {3, 0}}, {1, 0}, 1) < 0);
  CHECK(stability({{1, 1}, {1, 1}, {1, 1}}, {1, 1}, 1) < 0);
}
