// Polygons cut into triangles: every one is covered once, for any shape, size and plane.
#include "sim/mesh/polygon.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "sim/surface/surface_mesh.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

double area(const SurfaceMesh& s) {
  double sum = 0;
  for (const auto& [a, b, c] : s.triangles)
    sum += (s.positions[b] - s.positions[a]).cross(s.positions[c] - s.positions[a]).norm() / 2;
  return sum;
}

}  // namespace

TEST_CASE("concave polygons are cut into triangles that cover them once, at any size") {
  for (const double scale : {1.0, 1e-6, 1e6}) {
    const auto vertex = [&](double x, double y) { return "v " + std::to_string(x) + " 0 " + std::to_string(y) + "\n"; };
    // A dart whose short diagonal lies outside, and a comb of 20 corners.
    const SurfaceMesh dart =
        read_obj_content("dart.obj", vertex(0, 0) + vertex(4, -1) + vertex(3.5, 0) + vertex(4, 1) + "f 1 2 3 4\n");
    REQUIRE(dart.triangles.size() == 2);
    CHECK(area(dart) == Approx(3.5));

    std::vector<Eigen::Vector3d> comb;
    std::vector<std::uint32_t> corners;
    double expected = 0;
    for (int tooth = 0; tooth < 9; ++tooth) comb.emplace_back(scale * tooth, 0, scale * (tooth % 2 ? 1 : 4));
    for (int tooth = 0; tooth < 8; ++tooth) expected += scale * scale * 2.5;
    comb.emplace_back(scale * 8, 0, 0);
    comb.emplace_back(0, 0, 0);
    for (std::uint32_t c = 0; c < comb.size(); ++c) corners.push_back(c);
    SurfaceMesh cut;
    cut.positions = comb;
    triangulate(comb, corners, cut.triangles);
    CHECK(cut.triangles.size() == comb.size() - 2);
    CHECK(area(cut) == Approx(expected).epsilon(1e-9));
  }
}

TEST_CASE("polygons of any shape are cut into triangles of their area") {
  std::mt19937 random(4);
  double largest = 0;
  for (int n = 4; n <= 255; n += 7) {
    std::vector<Vector3d> x;
    std::vector<std::uint32_t> corners;
    for (int i = 0; i < n; ++i) {
      const double radius = 0.2 + static_cast<double>(random() % 1000) / 1000, a = 2 * std::numbers::pi * i / n;
      x.emplace_back(radius * std::cos(a), radius * std::sin(a), 0);
      corners.push_back(static_cast<std::uint32_t>(i));
    }
    double expected = 0, sum = 0;
    for (int i = 0; i < n; ++i) expected += x[i].cross(x[(i + 1) % n]).z() / 2;
    std::vector<Triangle> triangles;
    triangulate(x, corners, triangles);
    REQUIRE(triangles.size() == static_cast<std::size_t>(n) - 2);
    for (const auto& [a, b, c] : triangles) {
      const double area = (x[b] - x[a]).cross(x[c] - x[a]).z() / 2;
      CHECK(area > -1e-12);
      sum += area;
    }
    largest = std::max(largest, std::abs(sum - expected));
  }
  std::printf("areas of polygons and of their triangles: differ by %g at most\n", largest);
  CHECK(largest < 1e-9);
}

TEST_CASE("a triangle stays as it is, and triangles are appended") {
  std::vector<Triangle> triangles{{9, 9, 9}};
  triangulate({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {2, 0, 1}, triangles);
  CHECK(triangles == std::vector<Triangle>{{9, 9, 9}, {2, 0, 1}});
}

TEST_CASE("a quadrilateral is cut along its shorter diagonal, wound as it was, in any plane") {
  for (const Vector3d& normal : {Vector3d(0, 0, 1), Vector3d(0, 0, -1), Vector3d(1, -2, 3)}) {
    CAPTURE(normal);
    const Vector3d n = normal.normalized(), u = n.unitOrthogonal(), v = n.cross(u);
    const std::vector<Vector3d> x{3 * u, v, -3 * u,
                                  -v};  // counterclockwise around the normal; the diagonal 1-3 is short
    std::vector<Triangle> triangles;
    triangulate(x, {0, 1, 2, 3}, triangles);
    REQUIRE(triangles.size() == 2);
    for (const Triangle& t : triangles) {
      CAPTURE(t[0], t[1], t[2]);
      CHECK(std::count(t.begin(), t.end(), 1u) == 1);
      CHECK(std::count(t.begin(), t.end(), 3u) == 1);
      CHECK((x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).dot(n) == Approx(6));  // twice the half of 6
    }
  }
}

TEST_CASE("degenerate and self-intersecting polygons are cut into some triangles") {
  for (const std::vector<Vector3d>& x :
       {std::vector<Vector3d>(5, Vector3d(1, 2, 3)),                                          // a point
        std::vector<Vector3d>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}},                    // a line
        std::vector<Vector3d>{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 2, 0.3}}}) {  // a bow tie
    std::vector<std::uint32_t> corners;
    for (std::uint32_t c = 0; c < x.size(); ++c) corners.push_back(c);
    std::vector<Triangle> triangles;
    triangulate(x, corners, triangles);
    CHECK(triangles.size() == x.size() - 2);
    for (const Triangle& t : triangles) {
      CHECK(t[0] != t[1]);
      CHECK(t[1] != t[2]);
      CHECK(t[2] != t[0]);
    }
  }
}
