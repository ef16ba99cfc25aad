// Abaqus files that are written: read back, and line by line where other programs are strict.
#include <catch2/catch.hpp>
#include <sstream>

#include "sim/mesh/io/fem/abaqus_write.h"
#include "sim/mesh/io/formats.h"
#include "sim/mesh/mid_edges.h"
#include "tests/support/meshes/samples.h"

using namespace fascia;
using namespace fascia::test;

namespace {

TetMesh two_tets() {
  TetMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1.5}};
  mesh.tets = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  mesh.regions = {1, 2};
  mesh.region_names = {{1, "left"}, {2, "right"}};
  mesh.groups = {{"clamp", {0, 2, 4}}, {"left", {0, 1, 2, 3}}, {"right", {1, 2, 3, 4}}};
  return mesh;
}

}  // namespace

TEST_CASE("an Abaqus file has the nodes, elements, regions and groups of its mesh") {
  const bool ten_nodes = GENERATE(false, true);
  TetMesh mesh = two_tets();
  if (ten_nodes) add_mid_edges(mesh, {1});  // one of the two
  const MeshFile back = read_mesh_content("a.inp", abaqus_text(mesh));
  CHECK(back.format == "Abaqus");
  CHECK(back.mesh.positions == mesh.positions);
  CHECK(back.mesh.tets == mesh.tets);
  CHECK(back.mid_edges == mesh.mid_edges);
  CHECK(back.mesh.regions == mesh.regions);
  CHECK(back.mesh.region_names == mesh.region_names);
  CHECK(back.mesh.groups.at("clamp") == mesh.groups.at("clamp"));
  CHECK(back.notes.empty() != ten_nodes);  // one about tets of ten nodes
  if (ten_nodes)
    CHECK(abaqus_text(mesh).find("*ELEMENT, TYPE=C3D10, ELSET=right\n2, 2, 3, 4, 5, ") != std::string::npos);
}

TEST_CASE("sets of an Abaqus file have names that its programs take, each its own") {
  TetMesh mesh = two_tets();
  mesh.region_names = {{1, "liver: tumour"}, {2, "LIVER__tumour"}};
  mesh.groups = {{"7", {0, 2, 4}}, {"with, comma", {0, 4}}, {std::string(200, 'x'), {1, 4}}};
  const AbaqusMesh written = abaqus_mesh(mesh);
  CHECK(written.regions == std::map<int, std::string>{{1, "liver__tumour"}, {2, "LIVER__tumour_2"}});
  CHECK(written.groups == std::map<std::string, std::string>{{"7", "set_7"},
                                                             {"with, comma", "with__comma"},
                                                             {std::string(200, 'x'), std::string(60, 'x')}});
  const MeshFile back = read_mesh_content("a.inp", written.text);
  CHECK(back.mesh.groups.at("set_7") == std::vector<std::uint32_t>{0, 2, 4});
  CHECK(back.mesh.region_names == std::map<int, std::string>{{1, "liver__tumour"}, {2, "LIVER__tumour_2"}});
}

TEST_CASE("numbers of an Abaqus file fit into 20 characters, and lines into 132") {
  TetMesh mesh = two_tets();
  mesh.positions[0] = {-1.2345678901234567e-5, 1.0 / 3, -1.7976931348623157e-300};
  while (mesh.positions.size() < 20000) mesh.positions.emplace_back(0.1, 0.2, 0.3);
  for (std::uint32_t v = 0; v < 20000; ++v) mesh.groups["many"].push_back(v);
  add_mid_edges(mesh, {0, 1});
  const std::string text = abaqus_text(mesh);
  std::istringstream lines(text);
  std::size_t longest_line = 0, longest_number = 0;
  for (std::string line; std::getline(lines, line);) {
    longest_line = std::max(longest_line, line.size());
    if (line[0] == '*') continue;
    std::istringstream numbers(line);
    for (std::string number; std::getline(numbers, number, ',');)
      longest_number = std::max(longest_number, number.find_last_not_of(' ') + 1 - number.find_first_not_of(' '));
  }
  CHECK(longest_line <= 132);
  CHECK(longest_number <= 20);
  const MeshFile back = read_mesh_content("a.inp", text);
  CHECK(back.mesh.positions[0].isApprox(mesh.positions[0], 1e-12));
  CHECK(back.mesh.positions[0].z() == Approx(mesh.positions[0].z()).epsilon(1e-12).margin(0));
  CHECK(back.mesh.positions[1] == mesh.positions[1]);
  CHECK(back.mesh.groups.at("many") == mesh.groups.at("many"));
}
