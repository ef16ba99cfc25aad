// Examination of meshes whose defects are known exactly.
#include "sim/mesh/mesh_check.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "sim/mesh/mesh_generate.h"
#include "tests/sim/mesh/checked_mesh.h"

using namespace fascia;
using namespace fascia::test;

namespace {

const std::vector<Eigen::Vector3d> kCorner = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

}  // namespace

TEST_CASE("the mesh check measures a corner tet exactly") {
  const MeshReport report = examined(make_mesh(kCorner, {{0, 1, 2, 3}}));
  CHECK(report.volume == Approx(1.0 / 6));
  CHECK(report.shortest_edge == Approx(1));
  CHECK(report.longest_edge == Approx(std::sqrt(2)));
  // Three right angles, and arccos(1/sqrt 3) along the sloping face.
  CHECK(report.smallest_dihedral_deg == Approx(std::acos(1 / std::sqrt(3)) * 180 / std::numbers::pi));
  CHECK(report.largest_dihedral_deg == Approx(90));
  CHECK(report.box_min == Eigen::Vector3d(0, 0, 0));
  CHECK(report.box_max == Eigen::Vector3d(1, 1, 1));
  CHECK(report.boundary_triangles == 4);
  CHECK(report.boundary_manifold);
  CHECK(report.slivers == 0);
}

TEST_CASE("unused vertices are counted and do not widen the box") {
  std::vector<Eigen::Vector3d> positions = kCorner;
  positions.insert(positions.begin(), {-50, 0, 0});
  positions.push_back({0, 90, 0});
  const MeshReport report = examined(make_mesh(positions, {{1, 2, 3, 4}}));
  CHECK(report.vertex_count == 6);
  CHECK(report.unused_vertices == 2);
  CHECK(report.components == 1);
  CHECK(report.box_min == Eigen::Vector3d(0, 0, 0));
  CHECK(report.box_max == Eigen::Vector3d(1, 1, 1));
}

TEST_CASE("components and non-manifold contacts of two tets") {
  const std::vector<Eigen::Vector3d> positions = {{0, 0, 0},  {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0},
                                                  {0, 0, -1}, {5, 5, 5}, {6, 5, 5}, {5, 6, 5}, {5, 5, 6}};
  const Tet first = {0, 1, 2, 3};
  struct Case {
    const char* contact;
    Tet second;
    std::size_t components, nonmanifold_edges, nonmanifold_vertices;
  };
  const Case c = GENERATE(Case{"none", {7, 8, 9, 10}, 2, 0, 0}, Case{"vertex", {0, 4, 5, 6}, 1, 0, 1},
                          Case{"edge", {0, 3, 4, 5}, 1, 1, 2}, Case{"face", {0, 1, 2, 6}, 1, 0, 0});
  const MeshReport report = examined(make_mesh(positions, {first, c.second}));
  CAPTURE(c.contact);
  CHECK(report.components == c.components);
  CHECK(report.nonmanifold_edges == c.nonmanifold_edges);
  CHECK(report.nonmanifold_vertices == c.nonmanifold_vertices);
  CHECK(report.boundary_manifold == (c.nonmanifold_edges + c.nonmanifold_vertices == 0));
}

TEST_CASE("three tets on one face leave an open boundary") {
  const MeshReport report = examined(make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {1, 1, 1}},
                                               {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}}));
  CHECK(report.nonmanifold_edges == 3);  // the edges of the shared face, each on three boundary triangles
  CHECK_FALSE(report.boundary_manifold);
}

TEST_CASE("slivers are those below 5 degrees, the worst named first and at most ten") {
  // A regular triangle of circumradius 1 (inradius 1/2) with the apex over its center: the dihedral angles along the
  // base are arctan(2 height), the smallest of the six.
  std::vector<Eigen::Vector3d> positions;
  std::vector<Tet> tets;
  const auto add = [&](double degrees) {
    const double height = 0.5 * std::tan(degrees * std::numbers::pi / 180);
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (int k = 0; k < 3; ++k) {
      const double angle = 2 * std::numbers::pi * k / 3;
      positions.push_back({std::cos(angle), std::sin(angle), 0});
    }
    positions.push_back({0, 0, height});
    tets.push_back({first, first + 1, first + 2, first + 3});
  };
  add(5.01);
  for (int k = 0; k < 12; ++k) add(4.99 - 0.1 * k);
  const MeshReport report = examined(make_mesh(positions, tets));
  CHECK(report.slivers == 12);
  REQUIRE(report.worst_slivers.size() == 10);
  CHECK(report.worst_slivers[0].tet == 12);
  CHECK(report.worst_slivers[9].tet == 3);
  // arccos near 1 keeps about half of double's digits.
  CHECK(report.worst_slivers[0].smallest_dihedral_deg == Approx(4.99 - 1.1).epsilon(1e-7));
  CHECK(report.smallest_dihedral_deg == Approx(4.99 - 1.1).epsilon(1e-7));
  const std::string text = report_text(make_mesh(positions, tets));
  INFO(text);
  CHECK(text.find("12 tets with a dihedral angle below 5 degrees: 12 (3.89), 11 (3.99)") != std::string::npos);
  CHECK(text.find("and 2 more") != std::string::npos);
}

TEST_CASE("regions have their names, counts and volumes, and the volumes add up") {
  TetMesh mesh = make_box(2, 1, 1, {2, 1, 1});
  for (std::size_t t = 0; t < 6; ++t) mesh.regions[t] = 7;
  for (std::size_t t = 6; t < 12; ++t) mesh.regions[t] = -1;
  mesh.region_names[7] = "tumour";
  const MeshReport report = examined(mesh);
  REQUIRE(report.regions.size() == 2);
  CHECK(report.regions[0].number == -1);
  CHECK(report.regions[0].name.empty());
  CHECK(report.regions[1].number == 7);
  CHECK(report.regions[1].name == "tumour");
  CHECK(report.regions[1].tets == 6);
  CHECK(report.regions[1].volume == Approx(1));
  CHECK(report.regions[0].volume + report.regions[1].volume == Approx(report.volume));
}
