// Features of Gmsh files only: several groups for one entity, elements of higher order, and their specific errors.
// Covers: gmsh_2, gmsh_4
#include <catch2/catch.hpp>

#include "sim/mesh/io/formats.h"
#include "tests/support/meshes/samples.h"

using namespace fascia;
using namespace fascia::test;

namespace {

std::string v2_error(const std::string& from, const std::string& to) {
  return error_of("m.msh", replaced(sample_content("v2.msh"), from, to));
}
std::string v4_error(const std::string& from, const std::string& to) {
  return error_of("m.msh", replaced(sample_content("v4.msh"), from, to));
}

}  // namespace

TEST_CASE("Gmsh: a volume in two groups has the first as region and both as groups", "[mesh_io]") {
  const std::string text = replaced(sample_content("v4.msh"), "1 0 0 0 1 1 1 1 3 1 1", "1 0 0 0 1 1 1 2 3 21 1 1");
  const TetMesh mesh = read_mesh_content("m.msh", text).mesh;
  CHECK(mesh.regions == std::vector<int>{3, 7});
  CHECK(mesh.groups.at("left part") == std::vector<std::uint32_t>{0, 1, 2, 3});
  CHECK(mesh.groups.at("21") == std::vector<std::uint32_t>{0, 1, 2, 3});
}

TEST_CASE("Gmsh: groups of one name are one group", "[mesh_io]") {
  const std::string text = replaced(sample_content("v2.msh"), "\"clamp\"", "\"tip\"");
  const TetMesh mesh = read_mesh_content("m.msh", text).mesh;
  CHECK(mesh.groups.at("tip") == std::vector<std::uint32_t>{0, 1, 2, 4});
  CHECK(mesh.groups.count("clamp") == 0);
}

TEST_CASE("Gmsh: elements of higher order keep their corners", "[mesh_io]") {
  const std::string text =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n10\n"
      "1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 .5 0 0\n6 .5 .5 0\n7 0 .5 0\n8 0 0 .5\n9 0 .5 .5\n10 .5 0 .5\n$EndNodes\n"
      "$Elements\n4\n1 11 2 4 1 1 2 3 4 5 6 7 8 9 10\n2 9 2 6 1 1 2 3 5 6 7\n3 8 2 8 1 1 2 5\n4 3 2 8 1 1 2 3 4\n"
      "$EndElements\n";
  const MeshFile file = read_mesh_content("m.msh", text);
  CHECK(file.mesh.positions.size() == 10);
  CHECK(file.mesh.tets == std::vector<Tet>{{0, 1, 2, 3}});
  CHECK(file.mesh.groups.at("4") == std::vector<std::uint32_t>{0, 1, 2, 3});
  CHECK(file.mesh.groups.at("6") == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(file.mesh.groups.at("8") == std::vector<std::uint32_t>{0, 1, 2, 3});  // the line and the quadrangle
  CHECK(file.notes == std::vector<std::string>{kHigherOrderNote});
  CHECK(file.ignored.lines == 1);
  CHECK(file.ignored.triangles == 1);
  CHECK(file.ignored.polygons == 1);
}

TEST_CASE("Gmsh: sections that are not about the mesh are skipped, wherever they are", "[mesh_io]") {
  for (const std::string file : {"v1.msh", "v2.msh", "v2_little.msh", "v4.msh", "v4_big.msh"}) {
    INFO(file);
    const std::string before = "$Comments\nmade by $grab\n$EndComments\n$POS\n1 2 3\n$ENDPOS\n";
    const TetMesh mesh = read_mesh_content("m.msh", before + sample_content(file) + before).mesh;
    CHECK(mesh.tets == sample_mesh().tets);
    CHECK(mesh.regions == sample_mesh().regions);
  }
}

TEST_CASE("Gmsh: bad sections and headers", "[mesh_io]") {
  CHECK(v2_error("2.2 0 8", "3 0 8") ==
        "m.msh:2: $MeshFormat: is Gmsh format version '3'; expected 1.0, 2.0 to 2.2, 4.0 or 4.1; 'gmsh FILE -save "
        "-format "
        "msh41' converts");
  CHECK(v2_error("2.2 0 8", "2.2 7 8") == "m.msh:2: $MeshFormat: the file type is 7; expected 0 (ASCII) or 1 (binary)");
  CHECK(v2_error("2.2 0 8", "2.2 0 4") == "m.msh:2: $MeshFormat: the data size is 4; expected 8");
  CHECK(v2_error("$EndNodes", "$EndNode") == "m.msh:19: $Nodes: '$EndNode' follows the last entry; expected $EndNodes");
  CHECK(error_of("m.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n") ==
        "m.msh:4: has no section of nodes; expected $Nodes");
  CHECK(error_of("m.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n") ==
        "m.msh:8: has no section of elements; expected $Elements");
  CHECK(error_of("m.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\nwrong\n") ==
        "m.msh:5: has no section of nodes; expected $Nodes");
}

TEST_CASE("Gmsh: bad nodes", "[mesh_io]") {
  CHECK(v2_error("$Nodes\n6", "$Nodes\n1000000000000") ==
        "m.msh:12: $Nodes: claims 1000000000000 nodes but only 242 bytes follow; expected a complete file");
  CHECK(v2_error("$Nodes\n6", "$Nodes\n-6") ==
        "m.msh:12: $Nodes: the number of nodes is '-6'; expected a whole number, not negative");
  CHECK(v2_error("$Nodes\n6", "$Nodes\n7") == "m.msh:19: $Nodes: a node tag is '$EndNodes'; expected a whole number");
  CHECK(v2_error("$Nodes\n6", "$Nodes\n5") == "m.msh:18: $Nodes: '6' follows the last entry; expected $EndNodes");
  CHECK(v2_error("3 1 0 0", "3 1 nan 0") == "m.msh:14: $Nodes: a node coordinate is nan; expected a finite number");
  CHECK(v2_error("3 1 0 0", "3 1 -inf 0") ==
        "m.msh:14: $Nodes: a node coordinate is infinite; expected a finite number");
  CHECK(v2_error("3 1 0 0", "3 1 1e999 0") ==
        "m.msh:14: $Nodes: a node coordinate is infinite; expected a finite number");
  CHECK(v2_error("3 1 0 0", "3 1 1.5x 0") == "m.msh:14: $Nodes: a node coordinate is '1.5x'; expected a number");
  CHECK(v2_error("3 1 0 0", "3 1 0") ==
        "m.msh:14: $Nodes: the line ends before a node coordinate; expected more numbers on it");
  CHECK(v2_error("3 1 0 0", "3 1 0 0 0") ==
        "m.msh:14: $Nodes: '0' follows the node coordinates; expected the end of the line");
  CHECK(v2_error("3 1 0 0", "10 1 0 0") ==
        "m.msh:12: $Nodes: node tag 10 occurs twice, again as node number 2; expected every tag once");
  CHECK(v4_error("\n10\n3\n", "\n10\n10\n") ==
        "m.msh:20: $Nodes: node tag 10 occurs twice, again as node number 2; expected every tag once");
  CHECK(v4_error("3 6 3 2000000000", "3 7 3 2000000000") == "m.msh:35: $Nodes: blocks hold 6 nodes; expected 7");
  CHECK(v4_error("3 6 3 2000000000", "3 5 3 2000000000") == "m.msh:33: $Nodes: block of 1 nodes; expected at most 0");
  CHECK(v4_error("3 6 3 2000000000", "3 1000000000000 3 2000000000")
            .starts_with("m.msh:20: $Nodes: claims 1000000000000 nodes but only "));
  CHECK(read_mesh_content("m.msh", replaced(sample_content("v2.msh"), "3 1 0 0", "3 +1 1e-999 0")).mesh.positions[1] ==
        Eigen::Vector3d(1, 0, 0));
}

TEST_CASE("Gmsh: bad elements", "[mesh_io]") {
  CHECK(v2_error("10 3 2000000000 4\n", "10 3 99 4\n") ==
        "m.msh:25: $Elements: element 4 names node 99; expected a node of $Nodes");
  CHECK(v2_error("$Elements\n5", "$Elements\n1000000000000") ==
        "m.msh:21: $Elements: claims 1000000000000 elements but only 160 bytes follow; expected a complete file");
  CHECK(v2_error("4 4 2 3 1", "4 777 2 3 1") ==
        "m.msh:25: $Elements: element type is 777; expected a Gmsh element type");
  CHECK(v2_error("4 4 2 3 1", "4 4 2 3000000000 1") ==
        "m.msh:25: $Elements: physical tag 3000000000; expected a 32-bit number");
  CHECK(v2_error("4 4 2 3 1", "4 4 4000000000 3 1") ==
        "m.msh:25: $Elements: the line ends before a tag of an element; expected more numbers on it");
  CHECK(v4_error("3 1 4 1\n", "3 1 5 1\n") == "m.msh:47: $Elements: element 4 names node 2; expected a node of $Nodes");
  CHECK(v4_error("3 1 4 1\n", "2 1 4 1\n") ==
        "m.msh:45: $Elements: element type 4 in a block of dimension 2; expected dimension 3");
  CHECK(v4_error("5 5 1 5", "5 6 1 5") == "m.msh:48: $Elements: blocks hold 5 elements; expected 6");

  const std::string head =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n$Elements\n1\n";
  CHECK(error_of("m.msh", head + "1 2 0 1 2 3\n$EndElements\n") ==
        "m.msh: is a surface of 1 face without tets; expected a tetrahedral mesh");
  CHECK(error_of("m.msh", head + "1 1 0 1 2\n$EndElements\n") ==
        "m.msh: holds no tets (3 vertices, 1 line, 0 triangles, 0 other cells); expected at least one");
}

TEST_CASE("Gmsh: bad binary files name the byte", "[mesh_io]") {
  const std::string v2 = sample_content("v2_little.msh"), v4 = sample_content("v4_little.msh");
  const std::size_t nodes = v2.find("$Nodes\n6\n") + 9;
  const auto bytes = [](const auto value) { return Bytes().add(value).text; };
  const auto at = [](const std::string& where, std::size_t byte) {
    return "m.msh: byte " + std::to_string(byte) + ", " + where + ": ";
  };

  std::string bad = v2;
  bad.replace(nodes + 4, 8, bytes(std::nan("")));
  CHECK(error_of("m.msh", bad) == at("$Nodes", nodes + 4) + "a node coordinate is nan; expected a finite number");

  CHECK(error_of("m.msh", v2.substr(0, nodes + 100)) ==
        at("$Nodes", nodes - 2) + "claims 6 nodes but only 101 bytes follow; expected a complete file");
  bad = replaced(v2, "$Elements\n5", "$Elements\n1000000000000");
  CHECK(error_of("m.msh", bad).find("claims 1000000000000 elements but only") != std::string::npos);

  const std::size_t mark = v2.find("1 8\n") + 4;
  bad = v2;
  bad.replace(mark, 4, bytes(7));
  CHECK(error_of("m.msh", bad) == at("$MeshFormat", mark) + "the byte order mark is 7; expected 1");

  const std::size_t counts = v4.find("$Nodes\n") + 7;
  bad = v4;
  bad.replace(counts + 8, 8, bytes(std::uint64_t{1000000000000}));
  CHECK(error_of("m.msh", bad).starts_with(at("$Nodes", counts + 8) + "claims 1000000000000 nodes but only "));

  const std::size_t last_node = v4.find("\n$EndElements") - 8;
  bad = v4;
  bad.replace(last_node, 8, bytes(std::uint64_t{99}));
  CHECK(error_of("m.msh", bad) == at("$Elements", last_node) + "element 5 names node 99; expected a node of $Nodes");
}
