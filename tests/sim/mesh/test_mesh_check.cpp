// Repair and check of meshes whose defects are known exactly.
#include "sim/mesh/mesh_check.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

#include "sim/mesh/mesh_generate.h"
#include "sim/mesh/vertex_check.h"

using namespace fascia;

namespace {

const std::vector<Eigen::Vector3d> kCorner = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

TetMesh make_mesh(std::vector<Eigen::Vector3d> positions, std::vector<Tet> tets) {
  TetMesh mesh;
  mesh.regions.assign(tets.size(), 0);
  mesh.positions = std::move(positions);
  mesh.tets = std::move(tets);
  return mesh;
}

MeshReport examine(const TetMesh& mesh) { return fascia::examine(mesh, repair(mesh)); }

std::string report_text(const TetMesh& mesh) {
  MeshFile file;
  file.mesh = mesh;
  file.format = "test";
  const MeshRepair repaired = repair(mesh);
  std::ostringstream out;
  print_report(out, file, repaired, fascia::examine(mesh, repaired));
  return out.str();
}

using Indices = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("repair does not change a good mesh") {
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
  // Its base is a triangle with the longest edge sqrt(2) * size; the height over it is the smallest of the four.
  const auto tet_of_height = [&](double height) {
    std::vector<Eigen::Vector3d> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, height}};
    for (Eigen::Vector3d& p : positions) p = size * (p + Eigen::Vector3d(offset, 0, 0));
    return make_mesh(positions, {{0, 1, 2, 3}});
  };
  CAPTURE(size, offset);
  // Coordinates at offset 3 are rounded to 4e-16, the limit is 1.4e-7: 1 % to either side is far beyond rounding.
  CHECK(repair(tet_of_height(0.99e-7 * std::sqrt(2))).degenerate == Indices{0});
  CHECK(repair(tet_of_height(1.01e-7 * std::sqrt(2))).degenerate.empty());
}

TEST_CASE("a mesh with all vertices in one point is degenerate, not a division by zero") {
  const TetMesh mesh = make_mesh({4, {1, 1, 1}}, {{0, 1, 2, 3}});
  CHECK(repair(mesh).degenerate == Indices{0});
  const MeshReport report = examine(mesh);
  CHECK(report.usable_tets == 0);
  CHECK(report.components == 0);
  CHECK(report.unused_vertices == 4);
  CHECK_FALSE(report.boundary_manifold);
  CHECK(report.unit_guess.empty());
  CHECK(report_text(mesh).find("0 of them usable") != std::string::npos);
}

TEST_CASE("the mesh check measures a corner tet exactly") {
  const MeshReport report = examine(make_mesh(kCorner, {{0, 1, 2, 3}}));
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
  const MeshReport report = examine(make_mesh(positions, {{1, 2, 3, 4}}));
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
  const MeshReport report = examine(make_mesh(positions, {first, c.second}));
  CAPTURE(c.contact);
  CHECK(report.components == c.components);
  CHECK(report.nonmanifold_edges == c.nonmanifold_edges);
  CHECK(report.nonmanifold_vertices == c.nonmanifold_vertices);
  CHECK(report.boundary_manifold == (c.nonmanifold_edges + c.nonmanifold_vertices == 0));
}

TEST_CASE("three tets on one face leave an open boundary") {
  const MeshReport report = examine(make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {1, 1, 1}},
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
  const MeshReport report = examine(make_mesh(positions, tets));
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
  const MeshReport report = examine(mesh);
  REQUIRE(report.regions.size() == 2);
  CHECK(report.regions[0].number == -1);
  CHECK(report.regions[0].name.empty());
  CHECK(report.regions[1].number == 7);
  CHECK(report.regions[1].name == "tumour");
  CHECK(report.regions[1].tets == 6);
  CHECK(report.regions[1].volume == Approx(1));
  CHECK(report.regions[0].volume + report.regions[1].volume == Approx(report.volume));
}

TEST_CASE("the unit guess advises a scale that makes the size plausible, and is empty if it is") {
  CHECK(guess_unit(0.25).empty());
  CHECK(guess_unit(0.001).empty());
  CHECK(guess_unit(3).empty());
  const auto contains = [](double extent, const std::string& words) {
    const std::string advice = guess_unit(extent);
    INFO(extent << ": " << advice);
    CHECK(advice.find(words) != std::string::npos);
  };
  contains(6.5, "6.5 m wide");
  contains(6.5, "millimetres? try --set bodies.0.transform.scale=0.001 (6.5 mm wide)");
  contains(6.5, "centimetres? try --set bodies.0.transform.scale=0.01 (65 mm wide)");
  contains(700, "scale=0.001 (700 mm wide)");
  CHECK(guess_unit(700).find("centimetres") == std::string::npos);  // 7 m
  contains(2e5, "scale=1e-06 (200 mm wide)");
  contains(2e-4, "millimetres twice? try --set bodies.0.transform.scale=1000 (200 mm wide)");
  CHECK(guess_unit(100, 1000).find("scale=1 (100 mm wide)") != std::string::npos);  // of a scale that is already set
  contains(1e9, "--set bodies.0.transform.scale=1e-10");
}

TEST_CASE("the report names its findings") {
  TetMesh mesh = make_box(2, 1, 1, {6.5, 1, 1});
  std::swap(mesh.tets[3][0], mesh.tets[3][1]);
  mesh.tets.push_back(mesh.tets[0]);
  for (int k = 0; k < 11; ++k) mesh.tets.push_back({0, 0, 1, 2});
  mesh.regions.assign(mesh.tets.size(), 2);
  mesh.region_names[2] = "tissue";
  mesh.groups["clamp"] = {0, 3, 6};
  mesh.positions.push_back({0, 0, 0});
  const std::string text = report_text(mesh);
  INFO(text);
  const auto has = [&](const std::string& line) { CHECK(text.find(line + "\n") != std::string::npos); };
  has("vertices    13, 1 of them in no usable tet");
  has("tets        24, 12 of them usable");
  has("box         6.5 x 1 x 1 m, from (0, 0, 0) to (6.5, 1, 1)");
  has("volume      6.5 m^3");
  has("components  1");
  has("boundary    20 triangles, manifold");
  has("regions     2  tissue  12 tets, 6.5 m^3");
  has("groups      clamp: 3 vertices");
  has("flipped     1 tet wound inside out, reoriented: 3");
  has("degenerate  11 tets lower than 1e-7 of the longest edge, left out: 13, 14, 15, 16, 17, 18, 19, 20, 21, 22 and 1 "
      "more");
  has("duplicated  1 tet with the vertices of an earlier one, left out: 12");
  CHECK(text.find("\nsize        6.5 m wide, too large for tissue") != std::string::npos);
}

TEST_CASE("halves that touch with vertices of their own are counted, and welded on request") {
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
  CHECK(examine(mesh).components == 2);
  CHECK(examine(mesh).coincident_vertices == 4);
  CHECK(report_text(mesh).find("vertices    16, 4 of them at the place of an earlier one") != std::string::npos);
  CHECK(weld(mesh) == 4);
  CHECK(mesh.positions == whole.positions);
  CHECK(mesh.tets == whole.tets);
  CHECK(mesh.groups["end"] == Indices{0, 1});
  CHECK(mesh.groups["crack"] == Indices{copies.begin()->first});
  CHECK(examine(mesh).coincident_vertices == 0);
  CHECK(weld(mesh) == 0);
}

TEST_CASE("a vertex of no tet coincides with no other") {
  TetMesh mesh = make_box(1, 1, 1, {1, 1, 1});
  mesh.positions.insert(mesh.positions.begin(), mesh.positions[0]);
  for (Tet& tet : mesh.tets)
    for (std::uint32_t& v : tet) ++v;
  CHECK(examine(mesh).coincident_vertices == 0);
}

TEST_CASE("a vertex that is far from all others is named, even if its tets are left out") {
  for (const double far : {1e6, 1e300}) {
    TetMesh mesh = make_box(3, 3, 3, {1, 1, 1});
    mesh.positions[5].x() = far;
    mesh.positions.push_back({1e9, 0, 0});  // of no tet
    const std::string text = report_text(mesh);
    INFO(text);
    CHECK(examine(mesh).far_vertices == Indices{5});
    CHECK(text.find("far off     1 vertex far from all others: 5 at (1e+") != std::string::npos);
    CHECK(text.find("without volume") == std::string::npos);
  }
  TetMesh graded = make_box(9, 9, 9, {1, 1, 1});
  for (Eigen::Vector3d& x : graded.positions) x *= std::pow(x.norm(), 3);
  CHECK(examine(graded).far_vertices.empty());
}
