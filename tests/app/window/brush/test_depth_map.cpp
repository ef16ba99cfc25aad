// Distances of the nearest tissue under the pixels of a part of the picture.
#include "app/window/brush/depth_map.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace fascia;

namespace {

using Corner = DepthMap::Corner;

/// Two triangles over the pixels 0 to 10, facing the eye or turned away, at this distance.
void add_square(DepthMap& map, bool faces, double distance, double beyond = -1) {
  const Corner a{0, 0, distance, beyond}, b{10, 0, distance, beyond}, c{10, 10, distance, beyond},
      d{0, 10, distance, beyond};
  if (faces) {  // counterclockwise as seen: rows count downwards
    map.add(a, c, b);
    map.add(a, d, c);
  } else {
    map.add(a, b, c);
    map.add(a, c, d);
  }
}

}  // namespace

TEST_CASE("the nearest of several surfaces, and nothing beside them") {
  DepthMap map({-2, -2}, {12, 12});
  CHECK(std::isinf(map.nearest(5.5, 5.5)));
  add_square(map, false, 4);
  add_square(map, true, 3);
  CHECK(map.nearest(5.5, 5.5) == Approx(3));
  CHECK(map.nearest(0.1, 9.9) == Approx(3));
  CHECK(std::isinf(map.nearest(11, 5)));
  CHECK(std::isinf(map.nearest(500, -500)));
  CHECK(map.farthest_around(5.5, 5.5) == Approx(3));
  CHECK(std::isinf(map.farthest_around(0.5, 5.5)));  // the background is beside it
}

TEST_CASE("distances are those of the plane in space, seen in perspective") {
  // A plane z = 1 + 0.5 x, seen from the origin along z with 100 pixels per unit of slope.
  DepthMap map({0, 0}, {99, 99});
  const auto corner = [](double x, double y) {
    const double z = 1 + 0.5 * x;
    return Corner{100 * x / z, 100 * y / z, z};
  };
  map.add(corner(0, 0), corner(1, 0), corner(0, 1));
  for (const auto& [px, py] : {std::pair{5, 5}, {20, 30}, {40, 10}}) {
    const double slope = (px + 0.5) / 100;  // x / z
    CHECK(map.nearest(px + 0.5, py + 0.5) == Approx(1 / (1 - 0.5 * slope)));
  }
}

TEST_CASE("what a section plane cuts away is not seen, and the cut is where the body is open") {
  DepthMap map({0, 0}, {9, 9});
  add_square(map, true, 2, 0.5);    // cut away
  add_square(map, false, 5, -0.5);  // the far side of the body
  CHECK(map.nearest(5, 5) == Approx(5));
  map.close_cut([](double, double) { return 3.0; });
  CHECK(map.nearest(5, 5) == Approx(3));

  INFO("a second body that is cut away as a whole leaves no cut");
  DepthMap other({0, 0}, {9, 9});
  add_square(other, true, 1, 1);
  add_square(other, false, 1.5, 0.9);
  other.close_cut([](double, double) { return 3.0; });
  CHECK(std::isinf(other.nearest(5, 5)));
}

TEST_CASE("triangles without area and those beside the map do nothing") {
  DepthMap map({0, 0}, {3, 3});
  map.add({1, 1, 1}, {2, 2, 1}, {3, 3, 1});
  map.add({100, 100, 1}, {200, 100, 1}, {100, 200, 1});
  map.add({-1e300, 0, 1}, {1e300, 0, 1}, {0, 1e300, 1});
  for (double x = 0.5; x < 4; ++x) CHECK(std::isinf(map.nearest(x, 1.5)));
}
