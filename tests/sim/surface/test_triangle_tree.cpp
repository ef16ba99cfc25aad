// The tree of a surface's triangles, compared with a search over all triangles.
#include "sim/surface/triangle_tree.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>

#include "tests/support/surfaces.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

double uniform(std::mt19937& random) { return static_cast<double>(random() % 1000000) / 1e6; }

/// Triangles of size 0.3 at random positions in the unit cube.
SurfaceMesh soup(std::uint32_t count, std::mt19937& random) {
  SurfaceMesh s;
  const auto point = [&] { return Vector3d(uniform(random), uniform(random), uniform(random)); };
  for (std::uint32_t t = 0; t < count; ++t) {
    const Vector3d at = point();
    for (int k = 0; k < 3; ++k) s.positions.push_back(at + 0.3 * point());
    s.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return s;
}

}  // namespace

TEST_CASE("winding numbers: inside, outside, in a cavity, near a hole") {
  const SurfaceMesh hollow = test::joined(test::make_sphere(40, 80, 1), test::turned(test::make_sphere(20, 40, 0.5)));
  const TriangleTree tree(hollow.positions, hollow.triangles);
  for (const auto& [radius, expected] : {std::pair(0.2, 0.0), {0.75, 1.0}, {0.9, 1.0}, {1.1, 0.0}, {5.0, 0.0}}) {
    for (const Vector3d& direction : {Vector3d(1, 0.2, 0.1), Vector3d(-0.3, -1, 0.4), Vector3d(0.1, 0.1, 1)}) {
      CAPTURE(radius);
      CHECK(std::abs(tree.winding(radius * direction.normalized()) - expected) < 0.05);
    }
  }
}

TEST_CASE("a line crosses the triangles that single tests find, with ascending shares") {
  std::mt19937 random(5);
  const SurfaceMesh s = soup(400, random);
  const TriangleTree tree(s.positions, s.triangles);
  std::size_t crossed = 0;
  for (int ray = 0; ray < 200; ++ray) {
    Vector3d a(uniform(random), uniform(random), -1), b(uniform(random), uniform(random), 2);
    if (ray % 4 == 1) b.head<2>() = a.head<2>();  // along an axis
    std::vector<double> expected;
    for (const auto& [i, j, k] : s.triangles) {  // the crossing solved as a linear system
      Eigen::Matrix3d m;
      m << s.positions[j] - s.positions[i], s.positions[k] - s.positions[i], a - b;
      const Vector3d found = m.inverse() * (a - s.positions[i]);
      if (found[0] >= 0 && found[1] >= 0 && found[0] + found[1] <= 1 && found[2] >= 0 && found[2] <= 1)
        expected.push_back(found[2]);
    }
    std::sort(expected.begin(), expected.end());
    const std::vector<double> shares = tree.crossings(a, b);
    CAPTURE(ray, shares, expected);
    REQUIRE(shares.size() == expected.size());
    for (std::size_t i = 0; i < shares.size(); ++i) CHECK(std::abs(shares[i] - expected[i]) < 1e-9);
    crossed += shares.size();
  }
  CHECK(crossed > 100);
}

TEST_CASE("a line through an edge of two triangles crosses the surface once") {
  const SurfaceMesh box = test::make_box_surface({1, 1, 1});
  const TriangleTree tree(box.positions, box.triangles);
  for (const double x : {0.1, 0.25, 0.5, 0.9}) {  // on the diagonals of two sides
    const std::vector<double> shares = tree.crossings({x, x, -1}, {x, x, 3});
    CAPTURE(x, shares);
    REQUIRE(shares.size() == 2);
    CHECK(shares[0] == Approx(0.25));
    CHECK(shares[1] == Approx(0.5));
  }
  CHECK(tree.crossings({0.3, 0.4, 0.2}, {0.3, 0.4, 0.8}).empty());  // from inside to inside
}

TEST_CASE("the nearest point is the nearest of all triangles' points") {
  std::mt19937 random(6);
  const SurfaceMesh s = soup(300, random);
  const TriangleTree tree(s.positions, s.triangles);
  for (int i = 0; i < 200; ++i) {
    const Vector3d p = 3 * Vector3d(uniform(random), uniform(random), uniform(random)) - Vector3d(1, 1, 1);
    double best = 1e9;
    for (const auto& [a, b, c] : s.triangles) {
      const Vector3d w = nearest_weights(p, s.positions[a], s.positions[b], s.positions[c]);
      best = std::min(best, (w[0] * s.positions[a] + w[1] * s.positions[b] + w[2] * s.positions[c] - p).norm());
    }
    const TriangleTree::Nearest nearest = tree.nearest(p);
    CAPTURE(p, best, nearest.distance);
    CHECK(nearest.distance == Approx(best));
    CHECK((nearest.point - p).norm() == Approx(best));
    const auto& [a, b, c] = s.triangles[nearest.triangle];
    const Vector3d w = nearest_weights(p, s.positions[a], s.positions[b], s.positions[c]);
    CHECK((w[0] * s.positions[a] + w[1] * s.positions[b] + w[2] * s.positions[c] - nearest.point).norm() < 1e-12);
  }
}

TEST_CASE("nearest weights are at a corner, on an edge or inside, and no point sampled is nearer") {
  const Vector3d a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  const auto close = [&](const Vector3d& p, const Vector3d& weights) {
    CAPTURE(p);
    CHECK((nearest_weights(p, a, b, c) - weights).norm() < 1e-15);
  };
  close({-1, -1, 3}, {1, 0, 0});
  close({5, 0.1, -2}, {0, 1, 0});
  close({0, 2, 0}, {0, 0, 1});
  close({0.25, -1, 1}, {0.75, 0.25, 0});
  close({-1, 0.5, 0}, {0.5, 0, 0.5});
  close({1, 1, 7}, {0, 0.5, 0.5});
  close({0.25, 0.5, 9}, {0.25, 0.25, 0.5});
  std::mt19937 random(7);
  for (int i = 0; i < 200; ++i) {
    std::array<Vector3d, 4> x;
    for (Vector3d& v : x) v = Vector3d(uniform(random), uniform(random), uniform(random));
    const Vector3d w = nearest_weights(x[3], x[0], x[1], x[2]);
    CHECK(w.sum() == Approx(1));
    CHECK(w.minCoeff() >= 0);
    const double distance = (w[0] * x[0] + w[1] * x[1] + w[2] * x[2] - x[3]).norm();
    for (int j = 0; j <= 20; ++j)
      for (int k = 0; j + k <= 20; ++k) {
        const Vector3d sample = (j * x[0] + k * x[1] + (20 - j - k) * x[2]) / 20;
        CHECK((sample - x[3]).norm() >= distance - 1e-12);
      }
  }
}

TEST_CASE("touching pairs are those whose boxes touch and that share no vertex, each once") {
  std::mt19937 random(8);
  SurfaceMesh s = soup(200, random);
  for (std::size_t t = 0; t + 1 < s.triangles.size(); t += 3) s.triangles[t][2] = s.triangles[t + 1][0];
  std::vector<Eigen::AlignedBox3d> boxes(s.triangles.size());
  for (std::size_t t = 0; t < boxes.size(); ++t)
    for (const std::uint32_t v : s.triangles[t]) boxes[t].extend(s.positions[v]);
  std::set<std::pair<std::size_t, std::size_t>> expected;
  for (std::size_t t = 0; t < boxes.size(); ++t)
    for (std::size_t u = t + 1; u < boxes.size(); ++u) {
      bool shared = false;
      for (const std::uint32_t v : s.triangles[t])
        for (const std::uint32_t w : s.triangles[u]) shared = shared || v == w;
      if (!shared && boxes[t].intersects(boxes[u])) expected.emplace(t, u);
    }
  std::set<std::pair<std::size_t, std::size_t>> found;
  std::size_t calls = 0;
  const TriangleTree tree(s.positions, s.triangles);
  CHECK(tree.for_touching_pairs([&](std::size_t t, std::size_t u) { ++calls, found.emplace(t, u); },
                                [](std::size_t) { return true; }));
  CAPTURE(calls, expected.size());
  CHECK(calls == found.size());
  CHECK(found == expected);
  CHECK(expected.size() > 100);
  CHECK_FALSE(tree.for_touching_pairs([](std::size_t, std::size_t) {}, [](std::size_t) { return false; }));
}

TEST_CASE("an empty tree finds nothing") {
  const TriangleTree tree({}, {});
  CHECK(tree.winding({0, 0, 0}) == 0);
  CHECK(tree.crossings({0, 0, 0}, {1, 0, 0}).empty());
  CHECK(tree.box().isEmpty());
}
