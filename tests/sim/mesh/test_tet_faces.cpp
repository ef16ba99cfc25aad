// The boundary of a set of tets: closed, outward, complete, in a fixed order.
#include "sim/mesh/tet_faces.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <utility>

#include "sim/mesh/mesh_generate.h"

using namespace fascia;

namespace {

using DirectedEdges = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

DirectedEdges directed_edges(const std::vector<Triangle>& triangles) {
  DirectedEdges edges;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  return edges;
}

}  // namespace

TEST_CASE("the boundary of a single tet is its four faces, wound outward") {
  const TetMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}, {}, {0}, {}, {}};
  const std::vector<Triangle> triangles = boundary_triangles(mesh.tets);
  REQUIRE(triangles.size() == 4);
  const Eigen::Vector3d center(0.25, 0.25, 0.25);
  for (const Triangle& t : triangles) {
    CAPTURE(t[0], t[1], t[2]);
    const Eigen::Vector3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    CHECK((b - a).cross(c - a).dot(a - center) > 0);
  }
}

TEST_CASE("the boundary of a box is closed, has the box's area and faces outward") {
  const int nx = 4, ny = 3, nz = 2;
  const Eigen::Vector3d size(0.4, 0.3, 0.5);
  const TetMesh mesh = make_box(nx, ny, nz, size);
  const std::vector<Triangle> triangles = boundary_triangles(mesh.tets);
  REQUIRE(triangles.size() == 4u * (nx * ny + ny * nz + nz * nx));

  const DirectedEdges edges = directed_edges(triangles);
  for (const auto& [edge, count] : edges) {
    CAPTURE(edge.first, edge.second);
    CHECK(count == 1);
    CHECK(edges.count({edge.second, edge.first}) == 1);
  }
  double area = 0, volume = 0;
  for (const Triangle& t : triangles) {
    const Eigen::Vector3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const Eigen::Vector3d normal = (b - a).cross(c - a);  // its length is twice the area
    CHECK(normal.dot((a + b + c) / 3 - size / 2) > 0);
    area += normal.norm() / 2;
    volume += a.dot(normal) / 6;  // divergence theorem
  }
  // A few hundred additions of numbers below 1: rounding stays below 1e-13.
  CHECK(area == Approx(2 * (0.4 * 0.3 + 0.3 * 0.5 + 0.5 * 0.4)).epsilon(1e-12));
  CHECK(volume == Approx(0.4 * 0.3 * 0.5).epsilon(1e-12));
}

TEST_CASE("the boundary omits faces that several tets share and follows the order of the tets") {
  // Three tets on the face 0 1 2: 3 * 3 faces remain.
  const std::vector<Tet> tets = {{0, 1, 2, 5}, {0, 1, 2, 4}, {0, 2, 1, 3}};
  const std::vector<Triangle> triangles = boundary_triangles(tets);
  REQUIRE(triangles.size() == 9);
  for (std::size_t k = 0; k < 9; ++k) {
    CAPTURE(k);
    const std::uint32_t apex = tets[k / 3][3];
    CHECK(std::count(triangles[k].begin(), triangles[k].end(), apex) == 1);
  }
}

TEST_CASE("no tets have no boundary") { CHECK(boundary_triangles({}).empty()); }
