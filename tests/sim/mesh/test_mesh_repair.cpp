// The usable tets of a mesh, on meshes whose defects are known exactly.
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/mesh/mesh_generate.h"
#include "tests/sim/mesh/checked_mesh.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("repair keeps a good mesh as it is") {
  const TetMesh mesh = make_box(2, 2, 2, {1, 1, 1});
  const MeshRepair result = repair(mesh);
  CHECK(result.tets == mesh.tets);
  REQUIRE(result.source.size() == mesh.tets.size());
  for (std::uint32_t t = 0; t < result.source.size(); ++t) CHECK(result.source[t] == t);
  CHECK(result.flipped.empty());
  CHECK(result.degenerate.empty());
  CHECK(result.duplicated.empty());
}

TEST_CASE("repair reorients flipped tets, leaves out degenerate and duplicated ones, and names them by file index") {
  TetMesh mesh = make_box(1, 1, 1, {1, 1, 1});
  const std::vector<Tet> good = mesh.tets;
  std::swap(mesh.tets[1][0], mesh.tets[1][3]);
  mesh.tets.insert(mesh.tets.begin() + 2, Tet{0, 1, 2, 1});               // repeated vertex
  mesh.tets.insert(mesh.tets.begin() + 4, Tet{0, 1, 2, 3});               // flat
  mesh.tets.push_back(good[5]);                                           // the same tet
  mesh.tets.push_back({good[0][1], good[0][0], good[0][2], good[0][3]});  // the same, flipped
  mesh.regions.assign(mesh.tets.size(), 0);

  const MeshRepair result = repair(mesh);
  CHECK(result.source == Indices{0, 1, 3, 5, 6, 7});
  CHECK(result.flipped == Indices{1});
  CHECK(result.degenerate == Indices{2, 4});
  CHECK(result.duplicated == Indices{8, 9});
  for (std::size_t t = 0; t < result.tets.size(); ++t) {
    const Tet& tet = result.tets[t];
    const double volume6 =
        signed_volume6(mesh.positions[tet[0]], mesh.positions[tet[1]], mesh.positions[tet[2]], mesh.positions[tet[3]]);
    CAPTURE(t, volume6);
    CHECK(volume6 > 0);
  }
}

TEST_CASE("a tet is degenerate below a height of 1e-7 of its longest edge, at any size and place") {
  const double size = GENERATE(1e-6, 1.0, 1e6);
  const double offset = GENERATE(0.0, 3.0);
  // Its base is a triangle with the longest edge sqrt(2) * size; the height over it is the smallest of the
  // four.
  const auto tet_of_height = [&](double height) {
    std::vector<Eigen::Vector3d> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, height}};
    for (Eigen::Vector3d& p : positions) p = size * (p + Eigen::Vector3d(offset, 0, 0));
    return make_mesh(positions, {{0, 1, 2, 3}});
  };
  CAPTURE(size, offset);
  // Coordinates at offset 3 are rounded to 4e-16, the limit is 1.4e-7: 1 % to either side is far beyond
  // rounding.
  CHECK(repair(tet_of_height(0.99e-7 * std::sqrt(2))).degenerate == Indices{0});
  CHECK(repair(tet_of_height(1.01e-7 * std::sqrt(2))).degenerate.empty());
}

TEST_CASE("all vertices in one point is degenerate, not a division by zero") {
  const TetMesh mesh = make_mesh({4, {1, 1, 1}}, {{0, 1, 2, 3}});
  CHECK(repair(mesh).degenerate == Indices{0});
  const MeshReport report = examined(mesh);
  CHECK(report.usable_tets == 0);
  CHECK(report.components == 0);
  CHECK(report.unused_vertices == 4);
  CHECK_FALSE(report.boundary_manifold);
  CHECK(report.unit_guess.empty());
  CHECK(report_text(mesh).find("0 of them usable") != std::string::npos);
}
