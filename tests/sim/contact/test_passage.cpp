// When vertices and edges go through each other, against motions whose moment is known.
#include "sim/contact/tissue/penetration.h"

#include <catch2/catch.hpp>
#include <random>

namespace fascia {
namespace {

using Eigen::Vector3d;
using Corners = std::array<Vector3d, 4>;

Vector3d between(const Corners& x, const std::array<double, 4>& weights) {
  return weights[0] * x[0] + weights[1] * x[1] + weights[2] * x[2] + weights[3] * x[3];
}

TEST_CASE("a vertex goes through a triangle at the share of its way that is above it", "[contact]") {
  const Corners from{Vector3d(0.2, 0.3, 1), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  Corners to = from;
  to[0] = {0.2, 0.3, -3};
  const auto passage = vertex_through_triangle(from, to);
  REQUIRE(passage);
  CHECK(passage->share == Approx(0.25));
  CHECK(passage->normal.z() == Approx(1));
  CHECK(passage->weights[0] == 1);
  CHECK(passage->weights[1] == Approx(-0.5));
  CHECK(passage->weights[2] == Approx(-0.2));
  CHECK(passage->weights[3] == Approx(-0.3));
  CHECK(vertex_through_triangle(to, from)->normal.z() == Approx(-1));

  SECTION("not if it stops before, or passes beside") {
    to[0] = {0.2, 0.3, 0.1};
    CHECK_FALSE(vertex_through_triangle(from, to));
    to[0] = {2, 2, -3};
    CHECK_FALSE(vertex_through_triangle(from, to));
  }
  SECTION("not if both move alike") {
    for (std::size_t k = 0; k < 4; ++k) to[k] = from[k] + Vector3d(5, -7, 3);
    CHECK_FALSE(vertex_through_triangle(from, to));
  }
  SECTION("through a triangle that turns about it, before it returns") {
    // The triangle rises beyond the vertex and falls below it again in one cubic.
    to[0] = from[0];
    to[1] = {0, 0, 4};
    to[2] = {1, 0, 4};
    to[3] = {0, 1, 4};
    const auto turned = vertex_through_triangle(from, to);
    REQUIRE(turned);
    CHECK(turned->share == Approx(0.25));
    CHECK(turned->normal.z() == Approx(1));
  }
}

TEST_CASE("edges that cross go through each other", "[contact]") {
  const Corners from{Vector3d(-1, 0, 0.5), {1, 0, 0.5}, {0.5, -1, 0}, {0.5, 3, 0}};
  Corners to = from;
  to[0].z() = to[1].z() = -0.5;
  const auto passage = edge_through_edge(from, to);
  REQUIRE(passage);
  CHECK(passage->share == Approx(0.5));
  CHECK(passage->normal.z() == Approx(1));
  CHECK(passage->weights[1] == Approx(0.75));
  CHECK(passage->weights[3] == Approx(-0.25));
  to[2].x() = to[3].x() = 4;
  CHECK_FALSE(edge_through_edge(from, to));
  to = from;
  to[2] = {-1, 1, 0};
  to[3] = {1, 1, 0};
  CHECK_FALSE(edge_through_edge(from, to));  // parallel at the end, never at the height of the other
}

TEST_CASE("sides meet at the moment that is found, and come from where the normal says", "[contact]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int vertices = 0, edges = 0;
  for (int i = 0; i < 2000; ++i) {
    Corners from, to, then;
    for (std::size_t k = 0; k < 4; ++k) {
      from[k] = {uniform(random), uniform(random), uniform(random)};
      to[k] = {uniform(random), uniform(random), uniform(random)};
    }
    for (const bool of_edges : {false, true}) {
      const auto passage = of_edges ? edge_through_edge(from, to) : vertex_through_triangle(from, to);
      if (!passage) continue;
      ++(of_edges ? edges : vertices);
      for (std::size_t k = 0; k < 4; ++k) then[k] = from[k] + passage->share * (to[k] - from[k]);
      CAPTURE(i, of_edges, passage->share);
      REQUIRE(between(then, passage->weights).norm() < 1e-9);
      for (std::size_t k = 0; k < 4; ++k) then[k] -= 1e-6 * (to[k] - from[k]);
      REQUIRE(between(then, passage->weights).dot(passage->normal) > -1e-9);
      REQUIRE(passage->normal.norm() == Approx(1));
    }
  }
  CHECK(vertices > 100);
  CHECK(edges > 100);
}

}  // namespace
}  // namespace fascia
