// Vertices at the same position, and vertices far from all others.
#include "sim/mesh/vertex_check.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "sim/mesh/mesh_generate.h"
#include "sim/mesh/mid_edges.h"
#include "tests/sim/mesh/checked_mesh.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("the first vertex at exactly a place stands for the others there") {
  const double tiny = 5e-324;
  CHECK(first_at_place({}).empty());
  CHECK(first_at_place({{1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, tiny}, {0, 0, 0}, {1, 0, 0}}) ==
        Indices{0, 1, 0, 3, 1, 0});
  CHECK(first_at_place({{0, 0, 0}, {-0.0, 0, 0}}) == Indices{0, 0});
  CHECK(count_coincident({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}},
                         {{0, 1, 2, 3}, {4, 1, 2, 3}}) == 1);  // vertex 5 is in no tet
}

TEST_CASE("coordinates beyond float32 are refused") {
  require_range({{0, 0, 0}, {-3e38, 1, 0}}, "m.msh");
  CHECK_THROWS_WITH(require_range({{0, 0, 0}, {0, -1e300, 0}, {0, 1e300, 0}}, "m.msh"),
                    "m.msh: vertex 1 is at (0, -1e+300, 0), beyond the range of float32; expected coordinates of up to "
                    "3.403e+38");
}

TEST_CASE("halves that touch without shared vertices are counted, and welded on demand") {
  const TetMesh whole = make_box(2, 1, 1, {2, 1, 1});
  TetMesh mesh = whole;
  mesh.groups["end"] = {0, 1};
  std::map<std::uint32_t, std::uint32_t> copies;
  for (Tet& tet : mesh.tets) {
    double middle = 0;
    for (const std::uint32_t v : tet) middle += whole.positions[v].x() / 4;
    if (middle < 1) continue;
    for (std::uint32_t& v : tet) {
      if (whole.positions[v].x() > 1.5) continue;
      const auto [copy, is_new] = copies.try_emplace(v, static_cast<std::uint32_t>(mesh.positions.size()));
      if (is_new) mesh.positions.push_back(whole.positions[v]);
      v = copy->second;
    }
  }
  mesh.groups["crack"] = {copies.begin()->first, copies.begin()->second};
  REQUIRE(copies.size() == 4);
  CHECK(examined(mesh).components == 2);
  CHECK(examined(mesh).coincident_vertices == 4);
  CHECK(report_text(mesh).find("vertices    16, 4 of them at the place of an earlier one") != std::string::npos);
  CHECK(weld(mesh) == 4);
  CHECK(mesh.positions == whole.positions);
  CHECK(mesh.tets == whole.tets);
  CHECK(mesh.groups["end"] == Indices{0, 1});
  CHECK(mesh.groups["crack"] == Indices{copies.begin()->first});
  CHECK(examined(mesh).coincident_vertices == 0);
  CHECK(weld(mesh) == 0);
}

TEST_CASE("halves of quadratic tets are welded with the vertices in the middles of their edges") {
  TetMesh whole;
  whole.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  whole.tets = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  TetMesh apart = whole;
  apart.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  apart.tets[1] = {4, 5, 6, 7};
  add_mid_edges(apart, {0, 1});
  CHECK(weld(apart) == 6);  // three corners of the face, and the middles of its three edges
  CHECK(apart.tets == whole.tets);
  for (std::size_t t = 0; t < 2; ++t)
    for (std::size_t m = 0; m < 6; ++m) {
      const auto [a, b] = kMidEdgeCorners[m];
      const Eigen::Vector3d middle = 0.5 * (apart.positions[apart.tets[t][a]] + apart.positions[apart.tets[t][b]]);
      CHECK(apart.positions.at(apart.mid_edges[t][m]) == middle);
    }
  add_mid_edges(apart, {0});
  CHECK(weld(apart) == 6);  // the new middles, at the places of those before; the linear tet has none
  CHECK(apart.mid_edges[1] == kNoMidEdges);
}

TEST_CASE("a vertex in no tet does not coincide with another vertex") {
  TetMesh mesh = make_box(1, 1, 1, {1, 1, 1});
  mesh.positions.insert(mesh.positions.begin(), mesh.positions[0]);
  for (Tet& tet : mesh.tets)
    for (std::uint32_t& v : tet) ++v;
  CHECK(examined(mesh).coincident_vertices == 0);
}

TEST_CASE("a vertex that is far from all others is named, whether its tets are left out or not") {
  for (const double far : {1e6, 1e300}) {
    TetMesh mesh = make_box(3, 3, 3, {1, 1, 1});
    mesh.positions[5].x() = far;
    mesh.positions.push_back({1e9, 0, 0});  // in no tet
    const std::string text = report_text(mesh);
    INFO(text);
    CHECK(examined(mesh).far_vertices == Indices{5});
    CHECK(text.find("far off     1 vertex far from all others: 5 at (1e+") != std::string::npos);
    CHECK(text.find("without volume") == std::string::npos);
  }
  TetMesh graded = make_box(9, 9, 9, {1, 1, 1});
  for (Eigen::Vector3d& x : graded.positions) x *= std::pow(x.norm(), 3);
  CHECK(examined(graded).far_vertices.empty());
}
