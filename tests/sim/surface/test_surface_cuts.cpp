// Intersecting triangles of a surface: the pairs, and the number of pairs compared.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "sim/surface/surface_repair.h"

using namespace fascia;
using Eigen::Vector3d;

TEST_CASE("triangles around one vertex are not compared with each other") {
  constexpr std::uint32_t kAround = 50000;
  SurfaceMesh fan;  // a cone without its base
  fan.positions = {{0, 0.1, 0}};
  for (std::uint32_t i = 0; i < kAround; ++i) {
    const double angle = 2 * std::numbers::pi * i / kAround;
    fan.positions.emplace_back(0.1 * std::cos(angle), 0, 0.1 * std::sin(angle));
    fan.triangles.push_back({0, 1 + (i + 1) % kAround, 1 + i});
  }
  const TriangleTree tree(fan.positions, fan.triangles);
  std::size_t compared = 0;
  CHECK(tree.for_touching_pairs([](std::size_t, std::size_t) {},
                                [&](std::size_t count) { return (compared = count) < fan.triangles.size(); }));
  std::printf("%zu triangles: %zu pairs of boxes compared\n", fan.triangles.size(), compared);
  CHECK(self_intersections(tree).pairs.count == 0);

  // For thousands of intersections the search ends early and reports that.
  SurfaceMesh crossing;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    const double s = 1e-4 * i;
    for (const Vector3d& p : {Vector3d(0, 0, s), Vector3d(1, 1, 1 - s), Vector3d(1, 1.001, 1 - s)})
      crossing.positions.push_back(p);
    crossing.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  CHECK_FALSE(self_intersections(TriangleTree(crossing.positions, crossing.triangles)).complete);
}

TEST_CASE("the cuts are equal to those of a comparison of all pairs") {
  std::mt19937 random(3);
  const auto unit = [&] { return static_cast<double>(random() % 100000) / 100000; };
  SurfaceMesh soup;
  for (std::uint32_t t = 0; t < 300; ++t) {
    const Vector3d at(unit(), unit(), unit());
    for (int k = 0; k < 3; ++k) soup.positions.push_back(at + 0.3 * Vector3d(unit(), unit(), unit()));
    soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  std::size_t expected = 0;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    for (std::size_t u = t + 1; u < soup.triangles.size(); ++u)
      expected += self_intersections(TriangleTree(soup.positions, {soup.triangles[t], soup.triangles[u]})).pairs.count;
  const SelfIntersections found = self_intersections(TriangleTree(soup.positions, soup.triangles));
  std::printf("%zu pairs cut each other, %zu by comparing all\n", found.pairs.count, expected);
  CHECK(found.complete);
  CHECK(found.pairs.count == expected);
  CHECK(expected > 100);
}

TEST_CASE("two triangles cut each other where one goes through the other, and nowhere else") {
  const std::vector<Vector3d> flat{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  struct Row {
    const char* what;
    std::array<Vector3d, 3> other;
    bool cut;
  };
  for (const Row& row : {Row{"through the middle", {{{0.5, 0.5, -1}, {0.5, 0.5, 1}, {0.6, 0.5, 1}}}, true},
                         Row{"over an edge", {{{0.5, -1, -0.1}, {0.5, 1, -0.1}, {0.5, 0, 1}}}, true},
                         Row{"above", {{{0.5, 0.5, 0.1}, {0.5, 0.6, 1}, {0.6, 0.5, 1}}}, false},
                         Row{"beside, within the box", {{{1.5, 1.5, -1}, {1.5, 1.5, 1}, {1.6, 1.5, 1}}}, false}}) {
    CAPTURE(row.what);
    std::vector<Vector3d> x = flat;
    x.insert(x.end(), row.other.begin(), row.other.end());
    const SelfIntersections found = self_intersections(TriangleTree(x, {{0, 1, 2}, {3, 4, 5}}));
    CHECK(found.complete);
    CHECK(found.pairs.count == (row.cut ? 1 : 0));
  }
}
