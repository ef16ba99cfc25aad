// Gmsh files of version 4.0, in text and in binary of either byte order.
// Covers: gmsh_4
#include <catch2/catch.hpp>

#include "sim/mesh/io/formats.h"
#include "tests/support/meshes/samples.h"

using namespace fascia;
using namespace fascia::test;

namespace {

const std::string names_40 =
    "$PhysicalNames\n5\n0 9 \"tip\"\n2 4 \"clamp\"\n3 3 \"left part\"\n3 7 \"right\"\n1 6 \"x\"\n$EndPhysicalNames\n";

// A point 1 in group 9, a triangle of the surface 1 in group 4, volumes 1 and 2 in groups 3 and 7. The nodes of the
// surface have parametric coordinates.
const std::string ascii_40 =
    "$MeshFormat\n4 0 8\n$EndMeshFormat\n" + names_40 +
    "$Entities\n1 0 1 2\n1 1 1 1.5 1 1 1.5 1 9\n1 0 0 0 1 1 0 1 4 0\n1 0 0 0 1 1 1 1 3 1 1\n"
    "2 0 0 0 1 1 1.5 1 7 0\n$EndEntities\n"
    "$Nodes\n3 6\n1 2 1 3\n10 0 0 0 .5 .5\n20 1 0 0 .1 .1\n30 0 1 0 0 0\n1 3 1 1\n40 0 0 1\n2 3 0 2\n50 1 1 1.5\n"
    "60 9 8 7\n$EndNodes\n"
    "$Elements\n4 4\n1 0 15 1\n1 50\n1 2 2 1\n2 10 20 30\n1 3 4 1\n3 10 20 30 40\n2 3 4 1\n4 20 30 40 50\n"
    "$EndElements\n";

std::string binary_40(bool big_endian) {
  using Ints = std::vector<std::int32_t>;
  using Reals = std::vector<double>;
  using Sizes = std::vector<std::uint64_t>;
  Bytes out(big_endian);
  out.add_text("$MeshFormat\n4 1 8\n").add(std::int32_t{1}).add_text("\n$EndMeshFormat\n" + names_40 + "$Entities\n");
  out.add_all(Sizes{1, 0, 1, 2});
  const auto entity = [&](std::int32_t tag, const Reals& box, std::int32_t physical) {
    out.add(tag).add_all(box).add(std::uint64_t{1}).add(physical);
  };
  entity(1, {1, 1, 1.5, 1, 1, 1.5}, 9);
  entity(1, {0, 0, 0, 1, 1, 0}, 4);
  out.add(std::uint64_t{0});
  entity(1, {0, 0, 0, 1, 1, 1}, 3);
  out.add(std::uint64_t{1}).add(std::int32_t{1});
  entity(2, {0, 0, 0, 1, 1, 1.5}, 7);
  out.add(std::uint64_t{0}).add_text("\n$EndEntities\n$Nodes\n").add_all(Sizes{3, 6});
  const auto block = [&](const Ints& head, std::uint64_t count) { out.add_all(head).add(count); };
  const auto node = [&](std::int32_t tag, const Reals& numbers) { out.add(tag).add_all(numbers); };
  block({1, 2, 1}, 3);
  node(10, {0, 0, 0, .5, .5});
  node(20, {1, 0, 0, .1, .1});
  node(30, {0, 1, 0, 0, 0});
  block({1, 3, 1}, 1);
  node(40, {0, 0, 1});
  block({2, 3, 0}, 2);
  node(50, {1, 1, 1.5});
  node(60, {9, 8, 7});
  out.add_text("\n$EndNodes\n$Elements\n").add_all(Sizes{4, 4});
  block({1, 0, 15}, 1);
  out.add_all(Ints{1, 50});
  block({1, 2, 2}, 1);
  out.add_all(Ints{2, 10, 20, 30});
  block({1, 3, 4}, 1);
  out.add_all(Ints{3, 10, 20, 30, 40});
  block({2, 3, 4}, 1);
  out.add_all(Ints{4, 20, 30, 40, 50});
  return out.add_text("\n$EndElements\n").text;
}

void check_40(const MeshFile& file) {
  TetMesh expected = sample_mesh();
  expected.groups.erase("5");
  CHECK(file.mesh.positions == expected.positions);
  CHECK(file.mesh.tets == expected.tets);
  CHECK(file.mesh.regions == expected.regions);
  CHECK(file.mesh.region_names == expected.region_names);
  CHECK(file.mesh.groups == expected.groups);
  CHECK(file.notes.empty());
}

}  // namespace

TEST_CASE("Gmsh 4.0: text, as version 4 and 4.0") {
  const MeshFile file = read_mesh_content("m.msh", ascii_40);
  CHECK(file.format == "Gmsh 4 ASCII");
  check_40(file);
  check_40(read_mesh_content("m.msh", replaced(ascii_40, "4 0 8", "4.0 0 8")));
}

TEST_CASE("Gmsh 4.0: binary of either byte order") {
  for (const bool big_endian : {false, true}) {
    const MeshFile file = read_mesh_content("m.msh", binary_40(big_endian));
    CHECK(file.format == "Gmsh 4 binary");
    check_40(file);
  }
}

TEST_CASE("Gmsh 4.0: bad files") {
  const auto text_error = [](const std::string& from, const std::string& to) {
    return error_of("m.msh", replaced(ascii_40, from, to));
  };
  CHECK(text_error("50 1 1 1.5\n", "50 1 1\n") ==
        "m.msh:30: $Nodes: a node coordinate is '$EndNodes'; expected a number");
  CHECK(text_error("1 3 1 1\n40", "1 5 1 1\n40") ==
        "m.msh:25: $Nodes: dimension of a node block is 5; expected 0 to 3");
  CHECK(text_error("3 10 20 30 40\n", "3 10 20 30 41\n") ==
        "m.msh:38: $Elements: element 3 names node 41; expected a node of $Nodes");
  CHECK(text_error("$Nodes\n3 6", "$Nodes\n3 7") == "m.msh:29: $Nodes: blocks hold 6 nodes; expected 7");
  const std::string whole = binary_40(false);
  for (std::size_t length = 0; length + 14 < whole.size(); length += 7)
    CHECK(!error_of("m.msh", whole.substr(0, length)).empty());
}
