// Quadratic tets on their way from one file to another.
#include "sim/mesh/io/written_middles.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "sim/mesh/io/formats.h"
#include "sim/mesh/io/mesh_formats.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/mesh/mid_edges.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

/// As it is after it was read: the middles are beside the mesh.
MeshFile quadratic_file(std::size_t linear_tets = 0) {
  MeshFile file;
  file.mesh = make_box(2, 1, 1, {0.2, 0.1, 0.1});
  std::vector<std::uint32_t> tets(file.mesh.tets.size() - linear_tets);
  std::iota(tets.begin(), tets.end(), 0u);
  add_mid_edges(file.mesh, tets);
  file.mid_edges = std::move(file.mesh.mid_edges);
  file.mesh.mid_edges.clear();
  file.notes = {kHigherOrderNote};
  return file;
}

}  // namespace

TEST_CASE("files of quadratic tets from other programs keep their nodes in every format that has them", "[mesh_io]") {
  const std::string name =
      GENERATE("gmsh_4.1_second_order.msh", "gmsh_tets10.inp", "gmsh_second_order.mesh", "tetgen_cube.node");
  const std::string ending = GENERATE(from_range(ten_node_endings()));
  CAPTURE(name, ending);
  const TemporaryFolder folder;
  const std::filesystem::path out = folder / ("out" + ending);
  MeshFile file = read_mesh(test_dir() / "data/meshes" / name);
  keep_written_middles(file, out);
  CHECK(file.notes.empty());
  write_mesh(out, file.mesh);
  const MeshFile again = read_mesh(out);
  REQUIRE(again.mesh.positions.size() == file.mesh.positions.size());
  for (std::size_t v = 0; v < file.mesh.positions.size(); ++v)  // 13 digits in an Abaqus file
    CHECK((again.mesh.positions[v] - file.mesh.positions[v]).norm() <= (ending == ".inp" ? 1e-12 : 0));
  CHECK(again.mesh.tets == file.mesh.tets);
  CHECK(again.mid_edges == file.mesh.mid_edges);
  if (ending == ".inp") return;  // whose regions all have names
  CHECK(again.mesh.groups == file.mesh.groups);
  CHECK(again.mesh.region_names == file.mesh.region_names);
}

TEST_CASE("curved edges stay curved, and linear tets among quadratic ones stay linear", "[mesh_io]") {
  MeshFile file = quadratic_file(2);
  const std::vector<MidEdges> middles = file.mid_edges;
  const std::uint32_t curved = middles[0][3];
  file.mesh.positions[curved] += Eigen::Vector3d(0.005, -0.004, 0.003);
  const std::vector<Eigen::Vector3d> before = file.mesh.positions;
  file.mid_edges.resize(file.mesh.tets.size() - 2);  // readers stop at the last quadratic tet
  keep_written_middles(file, "out.msh");
  CHECK(file.mesh.positions == before);
  CHECK(file.mesh.mid_edges == middles);
  CHECK(file.notes.empty());
}

TEST_CASE("middles in the order of another format are put in order", "[mesh_io]") {
  MeshFile file = quadratic_file();
  const std::vector<MidEdges> middles = file.mid_edges;
  for (MidEdges& of_tet : file.mid_edges) std::swap(of_tet[4], of_tet[5]);
  keep_written_middles(file, "out.vtu");
  CHECK(file.mesh.mid_edges == middles);
  REQUIRE(file.notes.size() == 1);
  CHECK_THAT(file.notes[0], Catch::StartsWith("Middle vertices of " + std::to_string(middles.size()) + " quadratic"));
}

TEST_CASE("middles that are at no edge are written in the order of the file", "[mesh_io]") {
  MeshFile file = quadratic_file();
  const std::vector<MidEdges> middles = file.mid_edges;
  file.mesh.positions[middles[0][2]] += Eigen::Vector3d(5, 0, 0);
  keep_written_middles(file, "out.vtu");
  CHECK(file.mesh.mid_edges == middles);
  CHECK(file.notes == std::vector<std::string>{
                          "Middle vertices that are at no middle of an edge: written in the order of the file."});
}

TEST_CASE("a format without them gets the corners, and a note that names those with them", "[mesh_io]") {
  MeshFile file = quadratic_file(2);
  keep_written_middles(file, "out.NODE");
  CHECK(file.mesh.mid_edges.empty());
  CHECK(file.notes == std::vector<std::string>{"10 quadratic tets written with the corners alone, and the middle "
                                               "vertices in no tet: fascia writes .node with tets of four nodes, and "
                                               ".msh, .vtk, .vtu, .inp with tets of ten."});
}

TEST_CASE("corners of other cells of higher order are said to be kept, without an option that there is not",
          "[mesh_io]") {
  MeshFile none = quadratic_file(), split = quadratic_file();
  none.mid_edges.clear();
  keep_written_middles(none, "out.msh");
  CHECK(none.mesh.mid_edges.empty());
  CHECK(none.notes == std::vector<std::string>{"Cells of higher order: kept the corners of each."});
  split.split.tets = 5;
  keep_written_middles(split, "out.msh");
  CHECK_FALSE(split.mesh.mid_edges.empty());
  CHECK(split.notes == std::vector<std::string>{"Hexahedra, wedges and pyramids of higher order: kept the corners of "
                                                "each."});
  MeshFile linear;
  linear.mesh = make_box(1, 1, 1, {1, 1, 1});
  keep_written_middles(linear, "out.node");
  CHECK(linear.notes.empty());
}
