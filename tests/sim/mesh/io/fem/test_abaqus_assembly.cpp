// Abaqus files of several parts and instances: each at its place, with names of its own.
// Covers: abaqus_outline, abaqus_lines, merged_mesh
#include <catch2/catch.hpp>

#include "sim/mesh/io/formats.h"
#include "tests/support/meshes/samples.h"

using namespace fascia;
using namespace fascia::test;

namespace {

using Groups = std::map<std::string, std::vector<std::uint32_t>>;

const std::string bone =
    "*Part, name=Bone\n*Node\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n*Element, type=C3D4\n7,1,2,3,4\n"
    "*Nset, nset=Set-1\n1\n*Elset, elset=Set-1\n7\n*Solid Section, elset=Set-1, material=hard\n*End Part\n";
const std::string muscle =
    "*Part, name=Muscle\n*Node\n1,0,0,0\n2,2,0,0\n3,0,2,0\n4,0,0,2\n5,2,2,2\n*Element, type=C3D4\n1,1,2,3,4\n"
    "2,2,3,4,5\n*Nset, nset=end\n5\n*End Part\n";
const std::string shell =
    "*Part, name=Plate\n*Node\n1,0,0,0\n2,2,0,0\n3,0,2,0\n*Element, type=R3D3\n1,1,2,3\n*Node\n9,0,0,0\n*End Part\n";
const std::string instances =
    "*Assembly, name=Assembly\n*Instance, name=Bone-1, part=Bone\n*End Instance\n"
    "*Instance, name=Bone-2, part=BONE\n10, 0, 0\n10,0,0, 10,0,1, 90.\n*End Instance\n"
    "*Instance, name=Muscle-1, part=Muscle\n 0, 0, 5\n*End Instance\n"
    "*Node\n1, 5, 5, 5\n*Nset, nset=reference\n1\n"
    "*Nset, nset=Set-1, instance=bone-2\n2, 3\n*Nset, nset=low, instance=Bone-1, generate\n1, 3\n"
    "*Nset, nset=low, instance=Muscle-1\n1, end\n*Nset, nset=mixed\nBone-2.4, Muscle-1.end, Bone-1.Set-1\n"
    "*Nset, nset=all\nlow, mixed\n*Elset, elset=upper, instance=Muscle-1\n2\n*End Assembly\n*Material, name=hard\n";

MeshFile read(const std::string& content) { return read_mesh_content("a.inp", content); }

}  // namespace

TEST_CASE("Abaqus assemblies: every instance at its place, with its groups and regions") {
  const MeshFile file = read(bone + muscle + instances);
  CHECK(file.format == "Abaqus");
  const std::vector<Eigen::Vector3d> expected = {{0, 0, 0},  {1, 0, 0}, {0, 1, 0},  {0, 0, 1}, {10, 0, 0},
                                                 {10, 1, 0}, {9, 0, 0}, {10, 0, 1}, {0, 0, 5}, {2, 0, 5},
                                                 {0, 2, 5},  {0, 0, 7}, {2, 2, 7}};
  REQUIRE(file.mesh.positions.size() == expected.size());
  for (std::size_t v = 0; v < expected.size(); ++v) CHECK((file.mesh.positions[v] - expected[v]).norm() < 1e-12);
  CHECK(file.mesh.tets == std::vector<Tet>{{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}, {9, 10, 11, 12}});
  CHECK(file.mesh.regions == std::vector<int>{1, 2, 3, 3});
  CHECK(file.mesh.region_names ==
        std::map<int, std::string>{{1, "Bone-1.Set-1"}, {2, "Bone-2.Set-1"}, {3, "Muscle-1"}});
  CHECK(file.mesh.groups == Groups{{"Bone-1", {0, 1, 2, 3}},
                                   {"Bone-1.Set-1", {0, 1, 2, 3}},
                                   {"Bone-2", {4, 5, 6, 7}},
                                   {"Bone-2.Set-1", {4, 5, 6, 7}},
                                   {"Muscle-1", {8, 9, 10, 11, 12}},
                                   {"Muscle-1.end", {12}},
                                   {"Set-1", {5, 6}},
                                   {"low", {0, 1, 2, 8, 12}},
                                   {"mixed", {0, 7, 12}},
                                   {"all", {0, 1, 2, 7, 8, 12}},
                                   {"upper", {9, 10, 11, 12}}});
  CHECK(file.notes ==
        std::vector<std::string>{"Nodes of the assembly, which belong to no part, and sets of them are left out."});
}

TEST_CASE("Abaqus assemblies: instances of surfaces are left out beside solids, and read alone") {
  const std::string plates =
      "*Assembly, name=A\n*Instance, name=P-1, part=Plate\n*End Instance\n*Instance, name=P-2, part=Plate\n0,0,1\n"
      "*End Instance\n";
  const MeshFile solid = read(shell + bone + plates + "*Instance, name=B, part=Bone\n*End Instance\n*End Assembly\n");
  CHECK(solid.mesh.positions.size() == 4);
  CHECK(solid.mesh.groups == Groups{{"B", {0, 1, 2, 3}}, {"B.Set-1", {0, 1, 2, 3}}});
  CHECK(solid.notes == std::vector<std::string>{"Instances without solid elements left out: P-1, P-2."});
  const MeshFile surface = read(shell + plates);
  CHECK(surface.is_surface());
  CHECK(surface.faces.corners == std::vector<std::uint32_t>{0, 1, 2, 4, 5, 6});
  CHECK(surface.faces.ends == std::vector<std::size_t>{3, 6});
}

TEST_CASE("Abaqus assemblies: one instance of several parts keeps the names of its part") {
  const MeshFile file =
      read(bone + muscle + "*Assembly, name=A\n*Instance, name=M, part=Muscle\n*End Instance\n*End Assembly\n");
  CHECK(file.mesh.tets.size() == 2);
  CHECK(file.mesh.groups == Groups{{"end", {4}}});
}

TEST_CASE("Abaqus assemblies: an independent instance has its mesh in itself") {
  const std::string part = "*Part, name=P\n*End Part\n*Assembly, name=A\n";
  const std::string mesh =
      "*Node\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n*Element, type=C3D4\n1,1,2,3,4\n*Nset, nset=s\n1\n*End Instance\n";
  const MeshFile one = read(part + "*Instance, name=I, part=P\n1, 0, 0\n" + mesh + "*Nset, nset=s, instance=I\n2\n");
  CHECK(one.mesh.positions[0] == Eigen::Vector3d(1, 0, 0));
  CHECK(one.mesh.groups == Groups{{"s", {0}}, {"s (assembly)", {1}}});
  CHECK(one.notes.empty());
  const MeshFile two = read(part + "*Instance, name=I, part=P\n" + mesh + "*Instance, name=J, part=P\n0, 0, 2\n" +
                            mesh + "*Nset, nset=s, instance=J\n2\n");
  CHECK(two.mesh.groups == Groups{{"I", {0, 1, 2, 3}}, {"I.s", {0}}, {"J", {4, 5, 6, 7}}, {"J.s", {4}}, {"s", {5}}});
}

TEST_CASE("Abaqus assemblies: a set of the assembly may have the set of a part of its own name") {
  const MeshFile file = read(bone +
                             "*Assembly, name=A\n*Instance, name=B, part=Bone\n*End Instance\n*Nset, nset=Set-1\n"
                             "B.Set-1, B.4\n*End Assembly\n");
  CHECK(file.mesh.groups.at("Set-1 (assembly)") == std::vector<std::uint32_t>{0, 3});
}

TEST_CASE("Abaqus assemblies: quadratic tets keep their nodes") {
  const std::string ten =
      "*Part, name=Q\n*Node\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n5,.5,0,0\n6,.5,.5,0\n7,0,.5,0\n8,0,0,.5\n9,.5,0,.5\n"
      "10,0,.5,.5\n*Element, type=C3D10\n1,1,2,3,4,5,6,7,8,9,10\n*End Part\n*Assembly, name=A\n"
      "*Instance, name=B, part=Bone\n*End Instance\n*Instance, name=Q, part=Q\n*End Instance\n";
  const MeshFile file = read(bone + ten);
  CHECK(file.mid_edges == std::vector<MidEdges>{kNoMidEdges, {8, 9, 10, 11, 12, 13}});
}

TEST_CASE("Abaqus assemblies: bad files") {
  const auto inp_error = [](const std::string& from, const std::string& to) {
    return error_of("a.inp", replaced(bone + muscle + instances, from, to));
  };
  CHECK(error_of("a.inp", bone + muscle) ==
        "a.inp:1: has 2 parts and no *INSTANCE; expected one for each part to read");
  CHECK(inp_error("part=Muscle", "part=Nerve") == "a.inp:35: *INSTANCE: names part 'Nerve'; expected an earlier *PART");
  CHECK(inp_error("name=Muscle-1", "name=bone-1") ==
        "a.inp:35: *INSTANCE: is the second instance of the name 'bone-1'; expected every name once");
  CHECK(inp_error("1, end", "1, none") ==
        "a.inp:47: *NSET: names 'none'; expected a number or the name of an earlier set");
  CHECK(inp_error("7,1,2,3,4", "7,1,2,3,6") == "a.inp:8: element 7 names node 6; expected a node of the file");
  std::string many = bone + "*Assembly, name=A\n";
  for (int i = 0; i <= 1000; ++i) many += "*Instance, name=B" + std::to_string(i) + ", part=Bone\n*End Instance\n";
  CHECK(error_of("a.inp", many).find("is one instance too many; expected at most 1000") != std::string::npos);
}

TEST_CASE("Abaqus: constraints that join parts are left out with one note") {
  const std::string tie = "*Tie, name=glue\nbelow, above\n*Tie, name=glue-2\nleft, right\n", mpc = "*MPC\nBEAM, 1, 2\n",
                    note = "Constraints are left out, so that what they join moves apart: ";
  CHECK(read(bone + muscle + replaced(instances, "*End Assembly", tie + "*End Assembly")).notes ==
        std::vector<std::string>{"Nodes of the assembly, which belong to no part, and sets of them are left out.",
                                 note + "*TIE."});
  const std::string one = "*Node\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n*Element, type=C3D4\n7,1,2,3,4\n";
  CHECK(read(one + tie + mpc).notes == std::vector<std::string>{note + "*MPC, *TIE."});
  CHECK(read(one).notes.empty());
}
