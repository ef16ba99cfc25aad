#include "render/passes/surface_corners.h"
#include "tests/render/scene_support.h"

namespace fascia {
namespace {

using Catch::Matchers::Contains;
using test::Shape;

SurfaceCorners corners_of(const Shape& shape, bool with_rest) {
  return make_surface_corners(
      shape.triangles, static_cast<std::uint32_t>(shape.positions.size()),
      with_rest ? std::span<const Eigen::Vector3d>(shape.positions) : std::span<const Eigen::Vector3d>());
}

/// Properties of every surface: the triangles are unchanged, and every place of a triangle is in its corner's fan once.
void check_consistent(const Shape& shape, const SurfaceCorners& corners) {
  REQUIRE(corners.indices.size() == 3 * shape.triangles.size());
  REQUIRE(corners.fan.size() == 2 * corners.indices.size());
  REQUIRE(corners.fan_begin.size() == corners.vertex.size() + 1);
  CHECK(corners.fan_begin.back() == corners.indices.size());
  for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t corner = corners.indices[3 * t + k];
      REQUIRE(corners.vertex.at(corner) == shape.triangles[t][k]);
      int found = 0;
      for (std::uint32_t f = corners.fan_begin[corner]; f < corners.fan_begin[corner + 1]; ++f)
        found += corners.fan[2 * f] == shape.triangles[t][(k + 1) % 3] &&
                 corners.fan[2 * f + 1] == shape.triangles[t][(k + 2) % 3];
      CAPTURE(t, k, corner);
      REQUIRE(found == 1);
    }
  }
}

}  // namespace

TEST_CASE("a box has three corners at each of its own, two along its edges, one elsewhere") {
  for (const int cells : {1, 2, 5}) {
    const Shape shape = test::box({0, 0, 0}, {2, 1, 1}, cells);
    const SurfaceCorners sharp = corners_of(shape, true);
    check_consistent(shape, sharp);
    CAPTURE(cells);
    CHECK(sharp.vertex.size() == std::size_t(6 * (cells + 1) * (cells + 1)));  // every face has a separate grid
    const SurfaceCorners smooth = corners_of(shape, false);
    check_consistent(shape, smooth);
    CHECK(smooth.vertex.size() == shape.positions.size());
  }
}

TEST_CASE("a sphere is smooth with and without its rest shape") {
  const Shape shape = test::sphere({1, 2, 3}, 0.01, 12);
  for (const bool with_rest : {false, true}) {
    const SurfaceCorners corners = corners_of(shape, with_rest);
    check_consistent(shape, corners);
    CHECK(corners.vertex.size() == shape.positions.size());
  }
}

TEST_CASE("vertices without triangles have no corner, and triangles without area split nothing") {
  Shape shape = test::sphere({0, 0, 0}, 1, 8);
  shape.positions.push_back({5, 5, 5});
  const std::array<std::uint32_t, 3> first = shape.triangles[0];
  shape.triangles.push_back({first[0], first[1], first[1]});
  const SurfaceCorners corners = corners_of(shape, true);
  CHECK(corners.vertex.size() == shape.positions.size() - 1);
  CHECK(corners.indices.size() == 3 * shape.triangles.size());

  const SurfaceCorners none = make_surface_corners({}, 0, {});
  CHECK(none.vertex.empty());
  CHECK(none.fan_begin == std::vector<std::uint32_t>{0});
}

TEST_CASE("a triangle beyond the vertices is an Error") {
  const std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 1, 2}, {1, 2, 7}};
  CHECK_THAT(test::error_of([&] { make_surface_corners(triangles, 3, {}); }),
             Contains("surface: a triangle has vertex 7; expected vertices below 3"));
  const std::vector<Eigen::Vector3d> two(2);
  CHECK_THAT(test::error_of([&] { make_surface_corners({}, 3, two); }),
             Contains("surface: 2 rest positions; expected 3"));
}

TEST_CASE("where colors meet, a vertex has a corner for each, all with the normal of the whole fan") {
  // Two triangles in one plane, in two colors.
  const std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 1, 2}, {0, 2, 3}};
  const std::vector<Eigen::Vector3d> rest = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::uint32_t red = 0xff0000ff, none = 0;
  const SurfaceCorners corners =
      make_surface_corners(triangles, 4, rest, std::vector<std::uint32_t>{red, red, red, none, none, none});
  REQUIRE(corners.vertex.size() == 6);
  REQUIRE(corners.fan_begin.size() == 7);
  for (std::uint32_t place = 0; place < 6; ++place) {
    const std::uint32_t corner = corners.indices[place], vertex = triangles[place / 3][place % 3];
    CHECK(corners.vertex[corner] == vertex);
    CHECK(corners.colors[corner] == (place < 3 ? red : none));
    const std::uint32_t shared = vertex == 0 || vertex == 2 ? 2 : 1;
    CHECK(corners.fan_begin[corner + 1] - corners.fan_begin[corner] == shared);
  }
  CHECK(make_surface_corners(triangles, 4, rest, std::vector<std::uint32_t>(6, red)).vertex.size() == 4);
  CHECK(make_surface_corners(triangles, 4, rest).colors.empty());
}

}  // namespace fascia
