#include "app/bench/fill/filled_elements.h"

#include <catch2/catch.hpp>

#include "app/bench/fill/shapes.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

// A ball with as coarse fills as it can have.
TEST_CASE("bench elements compares fills of both elements with the finer one, whose own distance is nothing",
          "[bench]") {
  const TemporaryFolder folder;
  for (const Shape& shape : fill_shapes()) {
    if (shape.name == "sphere") write_shape(folder / "ball.obj", shape.surface);
  }
  BenchOptions options;
  options.out = folder.path().string();
  options.context = "osmesa";
  options.quiet = true;
  Bench bench(options, "elements");
  const std::vector<FilledPoint> points = compare_elements(bench, {folder / "ball.obj", 0.3, 6, 3, 8});
  REQUIRE(points.size() == 3);
  const FilledPoint &linear = points[0], &quadratic = points[1], &truth = points[2];
  CHECK(linear.elements == ElementOrder::linear);
  CHECK(quadratic.elements == ElementOrder::quadratic);
  CHECK(linear.resolution == 6);
  CHECK(quadratic.resolution == 3);
  CHECK(truth.resolution == 8);
  CHECK(quadratic.tets < linear.tets);
  for (const FilledPoint& point : {linear, quadratic}) {
    CAPTURE(name_of(point.elements), point.static_error, point.motion_error, point.free_error, point.least_det);
    CHECK(point.ms > 0);
    CHECK(point.static_error > 1e-3);
    CHECK(point.static_error < 1);
    CHECK(point.motion_error > 1e-3);
    CHECK(point.motion_error < 1);
    CHECK(point.free_error > 1e-3);
    CHECK(point.least_det < 1);
    CHECK(point.least_det_at_corners <= point.least_det + 1e-12);
  }
  // Against itself a fill has no error.
  const std::vector<FilledPoint> same = compare_elements(bench, {folder / "ball.obj", 0.3, 4, 4, 4});
  CHECK(same[1].static_error < 1e-4);
  CHECK(same[1].motion_error < 1e-4);
  CHECK(same[0].motion_error > 100 * same[1].motion_error);
}
