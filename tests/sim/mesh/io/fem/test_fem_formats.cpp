// Abaqus, FEBio and Vega files written here by hand: every part that is read, cuts at every byte, and their errors.
// Covers: abaqus, febio, fem_mesh, included_files, vega
#include <catch2/catch.hpp>

#include "base/error.h"
#include "sim/mesh/io/formats.h"
#include "tests/support/meshes/samples.h"

using namespace fascia;
using namespace fascia::test;

namespace {

const std::string abaqus =
    "*Heading\n two tets, 1, 2\n** comment\n*NODE, NSET=Nall\n10, 0, 0, 0\n20, 1., 0, 0, 0., 0., 1.\n30, 0, 1, 0\n"
    "40, 0, 0, 1e0\n50,1,1,1.5\n*Element, TYPE=C3D4,\n ELSET=left\n1, 10, 20, 30,\n 40\n*ELEMENT, type=c3d4h, "
    "elset=right\n"
    "2, 20, 30, 40, 50\n*ELEMENT, TYPE=SPRINGA\n7, 10, 50\n*NSET, NSET=clamp\n10, 20,\n30\n"
    "*nset, nset=Clamp\n50\n*NSET, NSET=all, GENERATE\n10, 45, 10\n*NSET, NSET=both\nCLAMP, 40\n*ELSET, ELSET=tissue, "
    "GENERATE\n"
    "1, 2\n*SOLID SECTION, ELSET=RIGHT, MATERIAL=soft\n1.,\n*SOLID SECTION, ELSET=left, MATERIAL=hard\n"
    "*MATERIAL, NAME=soft\n*ELASTIC\n1e5, 0.45\n";

const std::string febio =
    "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<febio_spec version=\"4.0\">\n<!-- by hand -->\n<Mesh>\n"
    "<Nodes name=\"Object1\">\n<node id=\"1\">0,0,0</node>\n<node id=\"2\">1, 0, 0</node>\n<node "
    "id=\"3\">0,1,0</node>\n"
    "<node id=\"4\"> 0.0,0.0,1.0 </node>\n<node id=\"5\">1,1,1.5</node>\n</Nodes>\n"
    "<Elements type=\"tet4\" name=\"left part\">\n<elem id=\"1\">1,2,3,4</elem>\n</Elements>\n"
    "<Elements type=\"tet4\" name=\"right\"><elem id=\"2\">2,3,4,5</elem></Elements>\n"
    "<Surface name=\"skin\"><tri3 id=\"1\">1,2,3</tri3></Surface>\n"
    "<NodeSet name=\"clamp\">1,2,\n3</NodeSet>\n<NodeSet name=\"tip\"><n id=\"5\"/></NodeSet>\n"
    "<ElementSet name=\"one\">2</ElementSet>\n</Mesh>\n</febio_spec>\n";

const std::string vega =
    "# by hand\n*VERTICES\n5 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1.5\n\n*ELEMENTS\nTET\n2 4 0\n"
    "1 1 2 3 4\n2 2 3 4 5\n*MATERIAL hard\nENU, 1000, 1e6, 0.45\n*SET end\n2,\n*REGION\nallElements, "
    "hard\n*REGION\nend, hard\n";

MeshFile read(const std::string& name, const std::string& content) { return read_mesh_content(name, content); }

void check_two_tets(const MeshFile& file, const std::vector<int>& regions) {
  CHECK(file.mesh.positions == std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1.5}});
  CHECK(file.mesh.tets == std::vector<Tet>{{0, 1, 2, 3}, {1, 2, 3, 4}});
  CHECK(file.mesh.regions == regions);
}

}  // namespace

TEST_CASE("Abaqus: nodes, elements, sets and sections") {
  const MeshFile file = read("a.inp", abaqus);
  CHECK(file.format == "Abaqus");
  check_two_tets(file, {2, 1});  // the sections' order
  CHECK(file.mesh.region_names == std::map<int, std::string>{{1, "right"}, {2, "left"}});
  const std::map<std::string, std::vector<std::uint32_t>> groups = {
      {"Nall", {0, 1, 2, 3, 4}}, {"clamp", {0, 1, 2, 4}}, {"all", {0, 1, 2, 3}},      {"both", {0, 1, 2, 3, 4}},
      {"left", {0, 1, 2, 3}},    {"right", {1, 2, 3, 4}}, {"tissue", {0, 1, 2, 3, 4}}};
  CHECK(file.mesh.groups == groups);
  CHECK(file.ignored.others == 1);
  CHECK(file.notes == std::vector<std::string>{"1 cell of other kinds than tets left out."});

  const std::size_t sections = abaqus.find("*SOLID");
  const MeshFile blocks = read("a.inp", abaqus.substr(0, sections));
  CHECK(blocks.mesh.region_names == std::map<int, std::string>{{1, "left"}, {2, "right"}});
  CHECK(blocks.mesh.regions == std::vector<int>{1, 2});
}

TEST_CASE("Abaqus: one part, placed by its instance") {
  const std::string part =
      "*PART, NAME=p\n*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n*ELEMENT, TYPE=C3D4\n1,1,2,3,4\n*END PART\n";
  const std::string instance =
      "*ASSEMBLY, NAME=a\n*INSTANCE, NAME=i, PART=p\n10, 0, 0\n10,0,0, 10,0,1, 90.\n*END INSTANCE\n*END ASSEMBLY\n";
  const MeshFile file = read("a.inp", part + instance);
  REQUIRE(file.mesh.positions.size() == 4);
  const Eigen::Vector3d expected[] = {{10, 0, 0}, {10, 1, 0}, {9, 0, 0}, {10, 0, 1}};
  for (std::size_t v = 0; v < 4; ++v) CHECK((file.mesh.positions[v] - expected[v]).norm() < 1e-12);
  CHECK(read("a.inp", part + "*ELSET, ELSET=e\n1\n*NSET, NSET=n, ELSET=e\n").mesh.groups.at("n") ==
        std::vector<std::uint32_t>{0, 1, 2, 3});
}

TEST_CASE("Abaqus: the assembly has sets and nodes of its own") {
  const MeshFile file = read(
      "a.inp",
      "*PART, NAME=p\n*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n*ELEMENT, TYPE=C3D4\n1,1,2,3,4\n*NSET, NSET=Set-1\n1\n"
      "*END PART\n*ASSEMBLY, NAME=a\n*INSTANCE, NAME=i-1, PART=p\n*END INSTANCE\n*NODE\n1, 5, 5, 5\n"
      "*NSET, NSET=reference\n1\n*NSET, NSET=set-1, INSTANCE=i-1\n2\n*NSET, NSET=ends, INSTANCE=i-1, GENERATE\n3, 4\n"
      "*NSET, NSET=some\ni-1.3, ends\n*NSET, NSET=other\nset-1\n*END ASSEMBLY\n");
  CHECK(file.mesh.positions.size() == 4);
  const std::map<std::string, std::vector<std::uint32_t>> groups = {
      {"Set-1", {0}}, {"set-1 (assembly)", {1}}, {"ends", {2, 3}}, {"some", {2, 3}}, {"other", {1}}};
  CHECK(file.mesh.groups == groups);
  CHECK(file.notes ==
        std::vector<std::string>{"Nodes of the assembly, which belong to no part, and sets of them are left out."});
}

TEST_CASE("Abaqus: other files that a file names are read in their place") {
  const std::map<std::string, std::string> files = {
      {"nodes.txt", "1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n"},
      {"more.inp", "*ELEMENT, TYPE=C3D4\n1,1,2,3,4\n*INCLUDE, INPUT=sets\n"},
      {"sets", "*NSET, NSET=low\n1,3\n"},
      {"again", "*INCLUDE, INPUT=again\n"}};
  const auto read_with = [&](const std::string& content) {
    return read_mesh_content("dir/a.inp", content, [&](const std::string& name) { return files.at(name); });
  };
  const std::string deck = "*NODE, INPUT=nodes.txt\n*INCLUDE, INPUT=more.inp\n*NSET, NSET=tip\n4\n";
  const MeshFile file = read_with(deck);
  CHECK(file.mesh.tets == std::vector<Tet>{{0, 1, 2, 3}});
  CHECK(file.mesh.groups == std::map<std::string, std::vector<std::uint32_t>>{{"low", {0, 2}}, {"tip", {3}}});
  CHECK(file.notes.empty());
  const auto error_with = [&](const std::string& content) {
    try {
      read_with(content);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(error_with("*NODE, INPUT=nodes.txt\n*ELEMENT, TYPE=C3D4, INPUT=nodes.txt\n") ==
        "dir/nodes.txt:1: *ELEMENT: the line ends before a node of an element; expected more numbers on it");
  CHECK(error_with("*INCLUDE, INPUT=again\n") ==
        "dir/again:1: *INCLUDE: is one included file too many; expected at most 32");
  CHECK(error_with("*INCLUDE\n") == "dir/a.inp:1: *INCLUDE: names ''; expected the name of a file");
}

TEST_CASE("Abaqus: bad files") {
  const auto inp_error = [](const std::string& from, const std::string& to) {
    return error_of("a.inp", replaced(abaqus, from, to));
  };
  CHECK(inp_error("30, 0, 1, 0", "30, 0, 1") ==
        "a.inp:7: *NODE: the line ends before a node coordinate; expected more numbers on it");
  CHECK(inp_error("30, 0, 1, 0", "30, 0, NaN, 0") ==
        "a.inp:7: *NODE: a node coordinate is nan; expected a finite number");
  CHECK(inp_error("30, 0, 1, 0", "20, 0, 1, 0") ==
        "a.inp:5: node 20 occurs twice in the list that begins here; expected every number once");
  CHECK(inp_error("2, 20, 30", "1, 20, 30").find("element 1 occurs twice") != std::string::npos);
  CHECK(inp_error("40, 50\n", "40, 60\n") == "a.inp:15: element 2 names node 60; expected a node of the file");
  CHECK(inp_error("30, 40, 50\n", "30, 40\n") ==
        "a.inp:15: *ELEMENT: the line ends before a node of an element; expected more numbers on it");
  CHECK(inp_error("30, 40, 50\n", "30, 40, 50, 10\n") ==
        "a.inp:15: *ELEMENT: '10' follows the nodes of an element; expected the end of the line");
  CHECK(inp_error("10, 20,\n30", "10, 20,\n31") == "a.inp:26: set 'both' names node 31; expected nodes of the file");
  CHECK(inp_error("CLAMP, 40", "none, 40") ==
        "a.inp:26: *NSET: names 'none'; expected a number or the name of an earlier set");
  CHECK(inp_error("10, 45, 10", "10, 45, 0") == "a.inp:24: *NSET: step is 0; expected 1 or more");
  CHECK(inp_error("10, 45, 10", "10, 5, 1") == "a.inp:24: *NSET: goes from 10 to 5; expected upward");
  CHECK(inp_error("*NODE, NSET=Nall", "*NODE, SYSTEM=C") ==
        "a.inp:4: *NODE: coordinates are in system 'C'; expected R, rectangular ones");
  CHECK(inp_error(", TYPE=SPRINGA", "") == "a.inp:16: *ELEMENT: has no TYPE; expected one such as TYPE=C3D4");
  CHECK(read("a.inp", replaced(abaqus, "10, 45, 10", "-9223372036854775808, 9223372036854775807, 9223372036854775807"))
            .mesh.groups.count("all") == 0);
}

TEST_CASE("FEBio: nodes, blocks and sets of versions 2 to 4, and elements of version 1") {
  const MeshFile file = read("a.feb", febio);
  CHECK(file.format == "FEBio 4.0");
  check_two_tets(file, {1, 2});
  CHECK(file.mesh.region_names == std::map<int, std::string>{{1, "left part"}, {2, "right"}});
  const std::map<std::string, std::vector<std::uint32_t>> groups = {
      {"Object1", {0, 1, 2, 3, 4}}, {"left part", {0, 1, 2, 3}}, {"right", {1, 2, 3, 4}},
      {"skin", {0, 1, 2}},          {"clamp", {0, 1, 2}},        {"tip", {4}},
      {"one", {1, 2, 3, 4}}};
  CHECK(file.mesh.groups == groups);

  const std::string old =
      "<febio_spec version=\"1.2\"><Geometry><Nodes><node id=\"1\">0,0,0</node><node id=\"2\">1,0,0</node><node "
      "id=\"3\">0,1,0</node><node id=\"4\">0,0,1</node></Nodes><Elements><tet4 id=\"1\" "
      "mat=\"7\">1,2,3,4</tet4></Elements></Geometry></febio_spec>";
  const MeshFile first = read("a.feb", old);
  CHECK(first.mesh.regions == std::vector<int>{7});
  CHECK(first.mesh.tets == std::vector<Tet>{{0, 1, 2, 3}});
}

TEST_CASE("FEBio: sets of other sets, which may stand behind them") {
  const auto clamp = [](const std::string& members) {
    const MeshFile file = read("a.feb", replaced(febio, "1,2,\n3", members));
    return std::pair(file.mesh.groups.contains("clamp") ? file.mesh.groups.at("clamp") : std::vector<std::uint32_t>(),
                     file.notes);
  };
  using Result = std::pair<std::vector<std::uint32_t>, std::vector<std::string>>;
  CHECK(clamp("@surface:skin") == Result({0, 1, 2}, {}));
  CHECK(clamp(" @elem_set:one\n") == Result({1, 2, 3, 4}, {}));
  CHECK(clamp("<n id=\"1\"/><node_set node_set=\"tip\"/>") == Result({0, 4}, {}));
  CHECK(clamp("@part_list:none") == Result({}, {"Set 'clamp' refers to 'none', which is left out of it."}));
  CHECK(clamp("<n id=\"1\"/><node_set node_set=\"clamp\"/>") ==
        Result({0}, {"Set 'clamp' refers to 'clamp', which is left out of it."}));
}

TEST_CASE("FEBio: tets of fifteen nodes keep ten, and blocks of shells beside solids are groups") {
  const std::string text =
      "<febio_spec version=\"4.0\"><Mesh><Nodes name=\"all\"><node id=\"101\">0,0,0</node><node id=\"102\">2,0,0</node>"
      "<node id=\"103\">0,2,0</node><node id=\"104\">0,0,2</node><node id=\"105\">1,0,0</node><node "
      "id=\"106\">1,1,0</node><node id=\"107\">0,1,0</node><node id=\"108\">0,0,1</node><node id=\"109\">1,0,1</node>"
      "<node id=\"110\">0,1,1</node><node id=\"111\">.7,.7,0</node><node id=\"112\">.7,0,.7</node><node "
      "id=\"113\">.7,.7,.7</node><node id=\"114\">0,.7,.7</node><node id=\"115\">.5,.5,.5</node></Nodes>"
      "<Elements type=\"tet15\" name=\"Part1\"><elem "
      "id=\"1\">101,102,103,104,105,106,107,108,109,110,111,112,113,114,115</elem></Elements>"
      "<Elements type=\"tri3\" name=\"Plate\"><elem id=\"2\">101,102,103</elem></Elements></Mesh>"
      "<MeshDomains><SolidDomain name=\"Part1\" mat=\"m\"/><ShellDomain name=\"Plate\" mat=\"m\"/></MeshDomains>"
      "</febio_spec>";
  const MeshFile file = read("a.feb", text);
  CHECK(file.mesh.tets == std::vector<Tet>{{0, 1, 2, 3}});
  CHECK(file.mid_edges == std::vector<MidEdges>{{4, 5, 6, 7, 8, 9}});
  CHECK(file.mesh.region_names == std::map<int, std::string>{{1, "Part1"}});
  CHECK(file.mesh.groups.at("Part1") == std::vector<std::uint32_t>{0, 1, 2, 3});
  CHECK(file.mesh.groups.at("Plate") == std::vector<std::uint32_t>{0, 1, 2});
}

TEST_CASE("FEBio: bad files") {
  const auto feb_error = [](const std::string& from, const std::string& to) {
    return error_of("a.feb", replaced(febio, from, to));
  };
  CHECK(feb_error("0,1,0<", "0,1<") ==
        "a.feb:8: node: the file ends before a node coordinate; expected a complete file");
  CHECK(feb_error("0,1,0<", "0,1,0,0<") ==
        "a.feb:8: node: something follows the node coordinates; expected the end of the element");
  CHECK(feb_error("0,1,0<", "0,inf,0<") == "a.feb:8: node: a node coordinate is infinite; expected a finite number");
  CHECK(feb_error("id=\"3\"", "id=\"x\"") == "a.feb:8: node: id is 'x'; expected a whole number");
  CHECK(feb_error("2,3,4,5", "2,3,4,6") == "a.feb:15: element 2 names node 6; expected a node of the file");
  CHECK(feb_error("2,3,4,5", "2,3,4,5,1") ==
        "a.feb:15: elem: something follows the nodes of an element; expected the end of the element");
  CHECK(feb_error("1,2,\n3", "1,2,\n9").find("set 'clamp' names node 9") != std::string::npos);
  CHECK(feb_error("1,2,\n3", "1,2,<!-- c -->3") ==
        "a.feb:17: NodeSet: has a comment in its text; expected numbers alone");
  CHECK(feb_error("<NodeSet name=\"tip\">", "<Part name=\"p\"></Part><NodeSet name=\"tip\">") ==
        "a.feb:19: Part: parts and their instances are not read; expected nodes and elements in Mesh itself, as FEBio "
        "Studio saves them");
  CHECK(feb_error("<Mesh>", "<Mesh from=\"other.feb\">") ==
        "a.feb:4: Mesh: is in another file, 'other.feb'; expected it in this one");
  CHECK(error_of("a.feb", "<febio_spec version=\"4.0\"></febio_spec>") ==
        "a.feb:1: febio_spec: has no element Mesh; expected Mesh, or Geometry before version 3");
}

TEST_CASE("Vega: vertices, elements, sets and regions, here and in included files") {
  const MeshFile file = read("a.veg", vega);
  CHECK(file.format == "Vega");
  check_two_tets(file, {1, 2});
  CHECK(file.mesh.region_names == std::map<int, std::string>{{1, "allElements"}, {2, "end"}});
  CHECK(file.mesh.groups.at("end") == std::vector<std::uint32_t>{1, 2, 3, 4});

  const std::string node = "5 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1.5\n";
  const auto beside = [&](const std::string& name) -> std::string {
    if (name == "m.node") return node;
    if (name == "m.ele") return "2 4 0\n1 1 2 3 4\n2 2 3 4 5\n";
    if (name == "loop.veg") return "*INCLUDE loop.veg\n";
    throw Error(name, "no such file", "");
  };
  const std::string text = "*VERTICES\n*INCLUDE m.node\n*ELEMENTS\nTET\n*INCLUDE m.ele\n";
  check_two_tets(read_mesh_content("a.veg", text, beside), {0, 0});
  CHECK_THROWS_WITH(read_mesh_content("a.veg", replaced(text, "m.ele", "n.ele"), beside), "n.ele: no such file");
  CHECK_THROWS_WITH(read_mesh_content("a.veg", "*INCLUDE loop.veg\n", beside),
                    Catch::Contains("is one included file too many; expected at most 32"));
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sub");
  write_sample(folder, {"", "m.node", node});
  write_sample(folder, {"", "m.ele", beside("m.ele")});
  check_two_tets(read_mesh(write_sample(folder, {"", "a.veg", text})), {0, 0});
}

TEST_CASE("Vega: bad files") {
  const auto veg_error = [](const std::string& from, const std::string& to) {
    return error_of("a.veg", replaced(vega, from, to));
  };
  CHECK(veg_error("5 3 0 0", "6 3 0 0") ==
        "a.veg:10: *VERTICES: a vertex number is '*ELEMENTS'; expected a whole number");
  CHECK(veg_error("5 3 0 0", "4 3 0 0") == "a.veg:8: found '5'; expected a section such as *VERTICES");
  CHECK(veg_error("5 3 0 0", "5 2 0 0") == "a.veg:3: *VERTICES: dimension is 2; expected 3");
  CHECK(veg_error("TET", "TRI") == "a.veg:12: *ELEMENTS: the kind of elements is 'TRI'; expected TET or CUBIC");
  CHECK(veg_error("2 4 0", "2 5 0") == "a.veg:12: *ELEMENTS: an element has 5 vertices; expected 4");
  CHECK(veg_error("2 2 3 4 5", "2 2 3 4 6").find("element 2 names node 6; expected a node of the file") !=
        std::string::npos);
  CHECK(veg_error("end\n2,", "end\n3,").find("set 'end' names element 3; expected elements of the file") !=
        std::string::npos);
  CHECK(veg_error("3 0 1 0", "3 0 nan 0") ==
        "a.veg:6: *VERTICES: a vertex coordinate is nan; expected a finite number");
}

// Abaqus files have neither counts nor an end: one that is cut behind a line is a whole file.
TEST_CASE("a file cut at any byte is refused, or noted, or holds the whole lines of an Abaqus file") {
  for (const auto& [name, content] :
       {std::pair("a.inp", abaqus), std::pair("a.feb", febio), std::pair("a.veg", vega)}) {
    const TetMesh whole = read(name, content).mesh;
    std::size_t refused = 0;
    for (std::size_t length = 0; length < content.size(); ++length) {
      CAPTURE(name, length);
      try {
        const MeshFile file = read(name, content.substr(0, length));
        if (file.mesh.positions == whole.positions && file.mesh.tets == whole.tets) continue;
        if (std::string(name) == "a.inp" && content[length - 1] == '\n') continue;
        bool told = false;
        for (const std::string& note : file.notes) told |= note.find("cut off") != std::string::npos;
        CHECK(told);
      } catch (const Error& error) {
        const std::string text = error.what();
        CHECK(text.starts_with(name));
        CHECK(text.find('\n') == std::string::npos);
        ++refused;
      }
    }
    INFO(name << ": " << refused << " of " << content.size() << " refused");
    CHECK(refused > content.size() / 4);
  }
}
