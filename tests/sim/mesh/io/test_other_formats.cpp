// TetGen and Medit: their specific freedoms and errors.
// Covers: medit, tetgen
#include <catch2/catch.hpp>
#include <fstream>

#include "sim/mesh/io/formats.h"
#include "tests/support/meshes/samples.h"

using namespace fascia;
using namespace fascia::test;

namespace {

const std::string node = "5 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n";
const std::string ele = "2 4 1\n1 1 2 3 4 8\n2 2 3 4 5 9\n";

std::string ele_error(const std::string& from, const std::string& to) {
  return error_of("m.ele", replaced(ele, from, to), node);
}
std::string node_error(const std::string& from, const std::string& to) {
  return error_of("m.ele", ele, replaced(node, from, to));
}

std::string medit_error(const std::string& from, const std::string& to) {
  for (const MeshSample& one : other_samples()) {
    if (one.file == "medit.mesh") return error_of("m.mesh", replaced(one.content, from, to));
  }
  return "no sample";
}

}  // namespace

TEST_CASE("TetGen: either file may be named, and both are needed", "[mesh_io]") {
  const TemporaryFolder folder;
  const auto path = write_sample(folder, {"", "m.ele", ele, Keeps::regions, node});
  for (const std::string name : {"m.ele", "m.node"}) {
    const TetMesh mesh = read_mesh(folder / name).mesh;
    CHECK(mesh.tets == std::vector<Tet>{{0, 1, 2, 3}, {1, 2, 3, 4}});
    CHECK(mesh.regions == std::vector<int>{8, 9});
  }
  CHECK(error_of("m.ele", ele) == "m.node: no such file; expected beside m.ele");
  CHECK(error_of("m.node", node) == "m.ele: no such file; expected beside m.node");
}

TEST_CASE("TetGen: bad files", "[mesh_io]") {
  CHECK(ele_error("2 3 4 5", "2 3 4 6") == "m.ele:3: tet 2 names vertex 6; expected a vertex of the .node file");
  CHECK(ele_error("2 3 4 5", "2 3 4 0") == "m.ele:3: tet 2 names vertex 0; expected a vertex of the .node file");
  CHECK(ele_error("2 4 1", "1000000000000 4 1") ==
        "m.ele:1: claims 1000000000000 tets but only 29 bytes follow; expected a complete file");
  CHECK(ele_error("2 4 1", "2 5 1") == "m.ele:1: a tet has 5 vertices; expected 4 or 10");
  CHECK(ele_error("2 4 1", "2 4 2") ==
        "m.ele:2: the line ends before an attribute of a tet; expected more numbers on it");
  CHECK(ele_error("2 4 1", "3 4 1") == "m.ele:4: the file ends before a tet number; expected a complete file");
  CHECK(ele_error("2 4 1", "1 4 1") == "m.ele:3: something follows the last of 1 tets; expected the end of the file");
  CHECK(node_error("5 3 0", "5 2 0") == "m.node:1: dimension is 2; expected 3");
  CHECK(node_error("3 0 1 0", "3 0 x 0") == "m.node:4: a vertex coordinate is 'x'; expected a number");
  CHECK(node_error("3 0 1 0", "3 0 NaN 0") == "m.node:4: a vertex coordinate is nan; expected a finite number");
  CHECK(node_error("3 0 1 0", "2 0 1 0") == "m.node:1: vertex number 2 occurs twice; expected every number once");
  CHECK(node_error("3 0 1 0", "3 0 1") ==
        "m.node:4: the line ends before a vertex coordinate; expected more numbers on it");
  CHECK(node_error("5 3 0", "1000000000000 3 0") ==
        "m.node:1: claims 1000000000000 vertices but only 47 bytes follow; expected a complete file");
  CHECK(error_of("m.ele", "0 4 0\n", node) ==
        "m.ele: holds no tets (5 vertices, 0 lines, 0 triangles, 0 other cells); expected at least one");
}

TEST_CASE("TetGen: an attribute that is not a whole number gives no regions, and a note", "[mesh_io]") {
  const TemporaryFolder folder;
  const MeshFile file =
      read_mesh(write_sample(folder, {"", "m.ele", replaced(ele, "5 9", "5 9.5"), Keeps::tets, node}));
  CHECK(file.mesh.regions == std::vector<int>{0, 0});
  CHECK(file.notes == std::vector<std::string>{"The first attribute of the tets is not a whole number: no regions."});
}

TEST_CASE("Medit: bad files", "[mesh_io]") {
  CHECK(medit_error("Dimension\n3", "Dimension\n2") == "m.mesh:4: Dimension: is 2; expected 3");
  CHECK(medit_error("Vertices\n6", "Vertices\n1000000000000")
            .starts_with("m.mesh:6: Vertices: claims 1000000000000 vertices but only "));
  CHECK(medit_error("Vertices\n6", "Vertices\n7") ==
        "m.mesh:13: Vertices: a vertex coordinate is 'Corners'; expected a number");
  CHECK(medit_error("9 8 7 0", "9 inf 7 0") ==
        "m.mesh:12: Vertices: a vertex coordinate is infinite; expected a finite number");
  CHECK(medit_error("2 3 4 5 7", "2 3 4 7 7") == "m.mesh:27: Tetrahedra: tet 2 names vertex 7; expected 1 to 6");
  CHECK(medit_error("2 3 4 5 7", "2 3 4 0 7") == "m.mesh:27: Tetrahedra: tet 2 names vertex 0; expected 1 to 6");
  CHECK(medit_error("Tetrahedra 2", "Tetrahedra 1") == "m.mesh:27: found '2'; expected a keyword");
  CHECK(medit_error("Vertices", "Verticos") == "m.mesh:18: Edges: edge 1 names vertex 1; expected 1 to 0");
  CHECK(medit_error("0.5 -1e-3", "0.5 #c\n -1e-3") == "");
  CHECK(medit_error("0.5 -1e-3", "0.5 !") == "m.mesh:24: SomethingNew: a value is '!'; expected a number");
}
