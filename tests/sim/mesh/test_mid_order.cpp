// Middle vertices that a file has in another order than its format.
// Covers: mid_order
#include "sim/mesh/mid_order.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "base/error.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/mesh/mid_edges.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

std::vector<std::uint32_t> all_tets(const TetMesh& mesh) {
  std::vector<std::uint32_t> tets(mesh.tets.size());
  std::iota(tets.begin(), tets.end(), 0u);
  return tets;
}

TetMesh quadratic_box(const Vector3d& size = {0.3, 0.2, 0.1}) {
  TetMesh mesh = make_box(3, 2, 1, size);
  add_mid_edges(mesh, all_tets(mesh));
  return mesh;
}

/// As a writer would that takes `order` for the format's.
std::vector<MidEdges> in_order(const std::vector<MidEdges>& mid_edges, const std::array<std::size_t, 6>& order) {
  std::vector<MidEdges> given = mid_edges;
  for (std::size_t t = 0; t < given.size(); ++t)
    for (std::size_t m = 0; m < 6; ++m) given[t][m] = mid_edges[t][order[m]];
  return given;
}

/// Bends the box to an arc about z of `angle` [rad], each vertex by its own place, so that edges become curved.
void bend(TetMesh& mesh, double angle) {
  const double radius = 0.3 / angle;
  for (Vector3d& x : mesh.positions) {
    const double turn = x.x() / radius, r = radius + x.y();
    x = {r * std::sin(turn), r * std::cos(turn), x.z()};
  }
}

}  // namespace

TEST_CASE("any order of middle vertices is put right by their places", "[mid_edges]") {
  const double angle = GENERATE(0.0, 0.5, 3.0);
  const double thin = GENERATE(0.1, 0.001);
  TetMesh mesh = quadratic_box({0.3, 0.2, thin});
  if (angle > 0) bend(mesh, angle);
  std::array<std::size_t, 6> order = {0, 1, 2, 3, 4, 5};
  do {
    std::vector<MidEdges> given = in_order(mesh.mid_edges, order);
    const bool same = given == mesh.mid_edges;
    const std::size_t reordered = order_mid_edges(mesh, all_tets(mesh), given, "m.vtu");
    if (given == mesh.mid_edges && reordered == (same ? 0 : mesh.tets.size())) continue;
    CAPTURE(angle, thin, order, reordered);
    FAIL_CHECK("another order");
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("middles at quarters of their edges and on half circles are those of curved edges", "[mid_edges]") {
  TetMesh mesh = quadratic_box();
  const MidEdge edge = mid_edges_of(mesh).front();
  const Vector3d along = mesh.positions[edge.b] - mesh.positions[edge.a];
  const Vector3d off = GENERATE(0.25, 0.49) * (GENERATE(true, false) ? along : along.norm() * along.unitOrthogonal());
  mesh.positions[edge.vertex] += off;
  std::vector<MidEdges> given = mesh.mid_edges;
  CHECK(order_mid_edges(mesh, all_tets(mesh), given, "m.vtu") == 0);
  CHECK(given == mesh.mid_edges);
}

TEST_CASE("vertices that are no middles of edges are an error that names the tet", "[mid_edges]") {
  const TetMesh mesh = quadratic_box();
  MeshFile file;
  file.mesh = mesh;
  file.mesh.mid_edges.clear();
  file.mid_edges = mesh.mid_edges;
  SECTION("numbered from another vertex on") {
    for (MidEdges& middles : file.mid_edges)
      for (std::uint32_t& v : middles) v = v + 1 == mesh.positions.size() ? 0 : v + 1;
    CHECK_THROWS_WITH(keep_mid_edges(file, all_tets(mesh), "m.vtu"),
                      Catch::StartsWith("m.vtu: tet 0 has vertex ") && Catch::Contains("for the middle of the edge"));
  }
  SECTION("in another order") {
    for (MidEdges& middles : file.mid_edges) std::swap(middles[4], middles[5]);
    const std::size_t count = mid_edges_of(mesh).size();
    CHECK(keep_mid_edges(file, all_tets(mesh), "m.vtu").size() == count);
    CHECK(file.mid_edges == mesh.mid_edges);
    CHECK(file.notes == std::vector<std::string>{"middle vertices of 36 quadratic tets are not in the order of the "
                                                 "format: put in order by their places"});
  }
  SECTION("one at two edges of a tet") {
    file.mid_edges[1][4] = file.mid_edges[1][5];
    CHECK_THROWS_WITH(keep_mid_edges(file, all_tets(mesh), "m.vtu"),
                      Catch::StartsWith("m.vtu: tet 1 has vertex " + std::to_string(mesh.mid_edges[1][5]) + " at ") &&
                          Catch::Contains(", and tet 1 for that at (") && Catch::Contains("; expected quadratic tets"));
  }
  SECTION("one at edges of two tets") {
    std::size_t other = 1;  // a tet that does not have the edge
    const std::uint32_t vertex = file.mid_edges[0][0];
    while (std::count(mesh.mid_edges[other].begin(), mesh.mid_edges[other].end(), vertex) > 0) ++other;
    file.mid_edges[other][3] = vertex;
    CHECK_THROWS_WITH(
        require_own_middles(mesh, all_tets(mesh), file.mid_edges, "m.vtu"),
        Catch::StartsWith("m.vtu: tet " + std::to_string(other) + " has vertex " + std::to_string(vertex) + " at ") &&
            Catch::Contains(", and tet 0 for that at ("));
  }
  SECTION("a corner") {
    file.mid_edges[0][0] = mesh.tets[0][1];
    CHECK_THROWS_WITH(keep_mid_edges(file, all_tets(mesh), "m.vtu"),
                      Catch::StartsWith("m.vtu: tet 0 has vertex " + std::to_string(mesh.tets[0][1])) &&
                          Catch::Contains(", and it is a corner of a tet; expected"));
  }
  SECTION("of some tets alone") {
    std::fill(file.mid_edges.begin() + 1, file.mid_edges.end(), kNoMidEdges);
    file.mesh.positions.resize(24 + 6);
    keep_mid_edges(file, all_tets(mesh), "m.vtu");
    CHECK(file.notes == std::vector<std::string>{
                            "35 tets of 4 nodes among 36 tets: " + std::to_string(mid_edges_of(mesh).size() - 6) +
                            " vertices added in the middles of edges"});
  }
  SECTION("as they should be") {
    keep_mid_edges(file, all_tets(mesh), "m.vtu");
    CHECK(file.notes.empty());
  }
}
