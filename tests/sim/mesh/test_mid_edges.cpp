// Mid-edge vertices of boxes, shared by the tets around an edge.
#include "sim/mesh/mid_edges.h"

#include <catch2/catch.hpp>
#include <numeric>
#include <set>

#include "sim/mesh/mesh_generate.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

TetMesh quadratic_box(int nx, int ny, int nz) {
  TetMesh mesh = make_box(nx, ny, nz, {0.4, 0.1, 0.2});
  std::vector<std::uint32_t> tets(mesh.tets.size());
  std::iota(tets.begin(), tets.end(), 0u);
  add_mid_edges(mesh, tets);
  return mesh;
}

}  // namespace

TEST_CASE("every edge of a box has one vertex in its middle, whichever of its tets asks", "[mid_edges]") {
  const TetMesh mesh = quadratic_box(3, 2, 2);
  REQUIRE(mesh.mid_edges.size() == mesh.tets.size());
  // The vertices of a box of twice the cells: 7 * 5 * 5.
  CHECK(mesh.positions.size() == 175);
  std::set<std::set<std::uint32_t>> edges;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (std::size_t m = 0; m < 6; ++m) {
      const std::uint32_t a = mesh.tets[t][kMidEdgeCorners[m][0]], b = mesh.tets[t][kMidEdgeCorners[m][1]];
      edges.insert({a, b});
      CHECK(mesh.positions[mesh.mid_edges[t][m]] == Vector3d(0.5 * (mesh.positions[a] + mesh.positions[b])));
    }
  CHECK(edges.size() == 175 - 36);
  const std::vector<MidEdge> all = mid_edges_of(mesh);
  REQUIRE(all.size() == edges.size());
  for (const MidEdge& edge : all) CHECK(edges.count({edge.a, edge.b}) == 1);
}

TEST_CASE("only the tets that are named become quadratic", "[mid_edges]") {
  TetMesh mesh = make_box(1, 1, 1, {1, 1, 1});
  add_mid_edges(mesh, {2});
  CHECK(mesh.positions.size() == 8 + 6);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) CHECK((mesh.mid_edges[t] == kNoMidEdges) == (t != 2));
  CHECK(mid_edges_of(mesh).size() == 6);
}

TEST_CASE("mid-edge vertices follow their edges when corners are renumbered", "[mid_edges]") {
  const Tet from = {10, 11, 12, 13};
  const MidEdges middles = {1011, 1112, 1012, 1013, 1113, 1213};  // named after their ends
  Tet to = from;
  do {
    const MidEdges moved = reordered(middles, from, to);
    for (std::size_t m = 0; m < 6; ++m) {
      const std::uint32_t a = to[kMidEdgeCorners[m][0]], b = to[kMidEdgeCorners[m][1]];
      CHECK(moved[m] == std::min(a, b) * 100 + std::max(a, b));
    }
  } while (std::next_permutation(to.begin(), to.end()));
}

TEST_CASE("given mid-edge vertices are kept, others added, and curved edges straightened", "[mid_edges]") {
  TetMesh mesh = quadratic_box(1, 1, 1);
  const std::vector<MidEdges> given = mesh.mid_edges;
  const TetMesh before = mesh;
  std::vector<std::uint32_t> tets(mesh.tets.size());
  std::iota(tets.begin(), tets.end(), 0u);
  add_mid_edges(mesh, tets, given);
  CHECK(mesh.mid_edges == given);
  CHECK(mesh.positions == before.positions);

  const std::uint32_t moved = given[0][2];
  mesh.positions[moved] += Vector3d(0.01, 0, 0);
  CHECK(straighten(mesh) == 1);
  CHECK(mesh.positions == before.positions);
  CHECK(straighten(mesh) == 0);

  std::vector<MidEdges> some{given[0]};
  some[0][3] = kNoVertex;
  add_mid_edges(mesh, {0}, some);
  CHECK(mesh.positions.size() == before.positions.size() + 1);
  CHECK(straighten(mesh) == 0);
  CHECK(mid_edges_of(mesh).size() == 6);
}
