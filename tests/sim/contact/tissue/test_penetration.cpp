#include "sim/contact/tissue/penetration.h"

#include <catch2/catch.hpp>

#include "tests/sim/reference/box_model.h"
#include "tests/support/touching_bodies.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

TEST_CASE("a segment goes through a triangle if it crosses its plane within it") {
  const Vector3d a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  CHECK(goes_through({0.2, 0.2, -1}, {0.2, 0.2, 1}, a, b, c));
  CHECK(goes_through({0.2, 0.2, 1}, {0.3, 0.2, -1}, a, b, c));
  CHECK_FALSE(goes_through({0.2, 0.2, 0.1}, {0.2, 0.2, 1}, a, b, c));
  CHECK_FALSE(goes_through({0.8, 0.8, -1}, {0.8, 0.8, 1}, a, b, c));
}

TEST_CASE("triangles that cut each other are counted, of two bodies and of one", "[contact]") {
  const Model box = test::box_model(2, 2, 2, {0.2, 0.2, 0.2}, test::soft(1e5));
  const auto cuts = [&](const Vector3d& way) {
    const Model model = test::beside(box, test::moved(box, way), "second");
    return penetrating_triangles(model, std::vector<Vector3d>(model.rest_positions.size(), Vector3d::Zero()));
  };
  CHECK(cuts({0.03, 0.21, 0.02}) == 0);
  CHECK(cuts({0.5, 0, 0}) == 0);
  // The lower corner of one box in the other: each of its three faces goes through three faces.
  CHECK(cuts({0.13, 0.17, 0.15}) > 3);

  // A corner that is pushed through the opposite face
  std::vector<Vector3d> u(box.rest_positions.size(), Vector3d::Zero());
  CHECK(penetrating_triangles(box, u) == 0);
  for (std::size_t v = 0; v < u.size(); ++v)
    if (box.rest_positions[v] == Vector3d(0.1, 0.2, 0.1)) u[v] = {0.01, -0.25, 0.02};
  CHECK(penetrating_triangles(box, u) > 0);
}

TEST_CASE("bodies that begin in each other are found, touching ones are not", "[contact]") {
  const Model box = test::box_model(4, 4, 4, {0.2, 0.2, 0.2}, test::soft(1e5));
  const auto at = [&](const Vector3d& way, const Model& other) {
    return overlaps_at_rest(test::beside(box, test::moved(other, way), "second"));
  };
  CHECK(at({0.2, 0, 0}, box).empty());
  CHECK(at({0.2 - 1e-5, 0, 0}, box).empty());
  CHECK(at({0.3, 0.1, 0}, box).empty());

  const std::vector<Overlap> same = at({0, 0, 0}, box);
  REQUIRE(same.size() == 2);
  for (const Overlap& overlap : same) {
    CHECK(overlap.other == 1 - overlap.body);
    CHECK(overlap.vertices == 27);  // of the inside: the others are on the surface
    CHECK(overlap.tets == box.tets.size());
    CHECK(overlap.deepest == Approx(0.1));
  }
  const std::vector<Overlap> corner = at({0.13, 0.13, 0.13}, box);
  REQUIRE(corner.size() == 2);
  CHECK(corner[0].vertices == 8);  // at 0.15 and 0.2 along each axis, up to 7 cm behind the sides at 0.13
  CHECK(corner[0].deepest == Approx(0.07));
  // Without a vertex inside: the middles of tets count
  const Model coarse = test::box_model(1, 1, 1, {0.2, 0.2, 0.2}, test::soft(1e5));
  const std::vector<Overlap> without = overlaps_at_rest(test::beside(coarse, coarse, "second"));
  REQUIRE(without.size() == 2);
  CHECK(without[0].vertices == 0);
  CHECK(without[0].tets == coarse.tets.size());
}

TEST_CASE("distances between segments and triangles are those of their nearest points", "[contact]") {
  test::Random random(4);
  for (int k = 0; k < 200; ++k) {
    const std::array<Vector3d, 2> a{random.vector(), random.vector()}, b{random.vector(), random.vector()};
    const std::array<Vector3d, 3> t{random.vector(), random.vector(), random.vector()};
    double between = 1e9, to_triangle = 1e9;
    constexpr int kShares = 40;
    for (int i = 0; i <= kShares; ++i) {
      const Vector3d p = a[0] + i * (a[1] - a[0]) / kShares;
      for (int j = 0; j <= kShares; ++j) {
        between = std::min(between, (p - b[0] - j * (b[1] - b[0]) / kShares).norm());
        for (int l = 0; j + l <= kShares; ++l)
          to_triangle = std::min(to_triangle, (p - t[0] - (j * (t[1] - t[0]) + l * (t[2] - t[0])) / kShares).norm());
      }
    }
    CAPTURE(k, between, to_triangle);
    const double found = distance_between(a, b);
    CHECK(found <= between + 1e-12);
    CHECK(found > between - 0.08);  // of the samples
    if (goes_through(a[0], a[1], t[0], t[1], t[2])) continue;
    const double nearest = distance_to_triangle(a, t);
    CHECK(nearest <= to_triangle + 1e-12);
    CHECK(nearest > to_triangle - 0.12);
  }
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), zero(0, 0, 0);
  CHECK(distance_between({zero, x}, {Vector3d(0.5 * x + y), Vector3d(3 * x + y)}) == Approx(1));  // parallel
  CHECK(distance_between({zero, x}, {Vector3d(0.5 * x - y), Vector3d(0.5 * x + y)}) == Approx(0).margin(1e-12));
}

}  // namespace
}  // namespace fascia
