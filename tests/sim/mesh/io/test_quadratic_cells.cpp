// Tets of ten nodes: each format's order of the middles of the edges, in files that other programs wrote, and in those
// that fascia writes.
#include <catch2/catch.hpp>
#include <numeric>

#include "base/file.h"
#include "sim/mesh/io/formats.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/mesh/mid_edges.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

/// Largest distance of a mid-edge vertex from the middle of the edge whose it should be, in edges.
double farthest_from_middle(const TetMesh& mesh, const std::vector<MidEdges>& mid_edges) {
  double farthest = 0;
  for (std::size_t t = 0; t < mid_edges.size(); ++t)
    for (std::size_t m = 0; m < 6; ++m) {
      const auto [a, b] = kMidEdgeCorners[m];
      const Eigen::Vector3d &from = mesh.positions[mesh.tets[t][a]], &to = mesh.positions[mesh.tets[t][b]];
      const Eigen::Vector3d off = mesh.positions.at(mid_edges[t][m]) - 0.5 * (from + to);
      farthest = std::max(farthest, off.norm() / (to - from).norm());
    }
  return farthest;
}

TetMesh quadratic_box() {
  TetMesh mesh = make_box(2, 1, 1, {0.2, 0.1, 0.1});
  std::vector<std::uint32_t> tets(mesh.tets.size() - 2);  // the last two stay linear
  std::iota(tets.begin(), tets.end(), 0u);
  add_mid_edges(mesh, tets);
  return mesh;
}

}  // namespace

TEST_CASE("tets of ten nodes are read with the middles of their edges", "[mesh_io]") {
  const std::string name =
      GENERATE("gmsh_4.1_second_order.msh", "gmsh_tets10.inp", "gmsh_second_order.mesh", "tetgen_cube.node");
  const MeshFile file = read_mesh(test_dir() / "data/meshes" / name);
  CAPTURE(name, file.mesh.tets.size());
  REQUIRE(file.mid_edges.size() == file.mesh.tets.size());
  CHECK(file.mesh.mid_edges.empty());
  CHECK(farthest_from_middle(file.mesh, file.mid_edges) < 1e-6);
}

TEST_CASE("tets of four nodes are read without middles", "[mesh_io]") {
  CHECK(read_mesh(test_dir() / "data/meshes/gmsh_tets.inp").mid_edges.empty());
}

TEST_CASE("quadratic cells are written and read again", "[mesh_io]") {
  const std::string name = GENERATE("box.msh", "box22.msh", "box.vtu", "box.vtk", "box.inp");
  const TemporaryFolder folder;
  const TetMesh mesh = quadratic_box();
  if (name == "box22.msh")
    write_file(folder / name, gmsh22_text(name, mesh));
  else
    write_mesh(folder / name, mesh);
  const MeshFile file = read_mesh(folder / name);
  CAPTURE(name, file.format);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)  // 13 digits in an Abaqus file
    CHECK((file.mesh.positions[v] - mesh.positions[v]).norm() < (name == "box.inp" ? 1e-13 : 1e-300));
  CHECK(file.mesh.tets == mesh.tets);
  std::vector<MidEdges> expected = mesh.mid_edges;
  expected.resize(file.mid_edges.size());  // none of the last tets
  CHECK(file.mid_edges.size() >= mesh.tets.size() - 2);
  CHECK(file.mid_edges == expected);
}
