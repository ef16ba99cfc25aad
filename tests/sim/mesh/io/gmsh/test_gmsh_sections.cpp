// Gmsh files as other programs write them: unneeded sections, extra numbers in an entity, tags without a line break,
// missing tags.
// Covers: gmsh_passed_over, gmsh_tags
#include <catch2/catch.hpp>
#include <cstdio>

#include "sim/mesh/io/formats.h"
#include "sim/mesh/io/gmsh/gmsh_tags.h"
#include "tests/support/meshes/samples.h"

using namespace fascia;
using namespace fascia::test;

namespace {

bool notes_mention(const MeshFile& file, const std::string& text) {
  for (const std::string& note : file.notes)
    if (note.find(text) != std::string::npos) return true;
  return false;
}

/// Reads a file and compares its mesh with the sample; returns it for its notes.
MeshFile check_read(const std::string& what, const std::string& content) {
  const MeshFile file = read_mesh_content("m.msh", content);
  std::printf("%s: %s, %zu vertices, %zu tets, %zu notes\n", what.c_str(), file.format.c_str(),
              file.mesh.positions.size(), file.mesh.tets.size(), file.notes.size());
  CHECK(file.mesh.positions == sample_mesh().positions);
  CHECK(file.mesh.tets == sample_mesh().tets);
  return file;
}

/// Two values for each of two elements or nodes, after a head of the given numbers of components and entries.
std::string data_section(const std::string& name, bool big_endian, int components, int entries, double value,
                         const std::string& before_end) {
  Bytes out(big_endian);
  out.add_text("$" + name + "\n1\n\"a view\"\n1\n0.0\n3\n0\n" + std::to_string(components) + "\n" +
               std::to_string(entries) + "\n");
  for (int entry = 1; entry <= 2; ++entry) {
    out.add(entry);
    if (name == "ElementNodeData") out.add(2);
    for (int i = 0; i < (name == "ElementNodeData" ? 4 : 2); ++i) out.add(value);
  }
  return out.add_text(before_end + "$End" + name + "\n").text;
}

/// The double whose bytes are these eight characters in a file of this byte order.
double number_of(std::string bytes, bool big_endian) {
  if (big_endian) bytes = std::string(bytes.rbegin(), bytes.rend());
  double value = 0;
  std::memcpy(&value, bytes.data(), sizeof value);
  return value;
}

}  // namespace

TEST_CASE("Gmsh: data of nodes and elements is skipped, with or without a line break before its end tag", "[mesh_io]") {
  for (const auto& [file, big_endian] : {std::pair("v2_little.msh", false),
                                         {"v2_big.msh", true},
                                         {"v4_little.msh", false},
                                         {"v4_big.msh", true},
                                         {"v4_small.msh", false}}) {
    for (const std::string name : {"NodeData", "ElementData", "ElementNodeData"}) {
      for (const std::string before_end : {"", "\n"}) {
        const std::string data = data_section(name, big_endian, 2, 2, 0.5, before_end);
        const std::string head = "$EndMeshFormat\n";
        const std::string whole = sample_content(file);
        CHECK(notes_mention(check_read(std::string(file) + " " + name + " behind", whole + data), "$" + name));
        check_read(std::string(file) + " " + name + " before", replaced(whole, head, head + data));
      }
    }
  }
}

TEST_CASE("Gmsh: numbers that look like a tag do not end a section", "[mesh_io]") {
  for (const auto& [file, big_endian] : {std::pair("v2_little.msh", false), {"v2_big.msh", true}}) {
    // Each entry: number 1 or 2, two doubles whose bytes are "$EndNode" and "Data\n$No".
    Bytes data(big_endian);
    data.add_text("$NodeData\n0\n0\n3\n0\n2\n2\n");
    for (int entry = 1; entry <= 2; ++entry)
      data.add(entry).add(number_of("$EndNode", big_endian)).add(number_of("Data\n$No", big_endian));
    data.add_text("$EndNodeData\n");
    REQUIRE(data.text.find("$EndNodeData\n") < data.text.size() - 20);
    const MeshFile read =
        check_read(std::string(file) + " with tags among its numbers",
                   replaced(sample_content(file), "$EndMeshFormat\n", "$EndMeshFormat\n" + data.text));
    CHECK_FALSE(notes_mention(read, "between sections"));
  }
}

TEST_CASE("Gmsh: counts of a skipped section need not be correct", "[mesh_io]") {
  for (const auto& [components, entries] : {std::pair(2, 1000000000), {2000000000, 2}, {1, 2}, {0, 0}, {-1, 2}}) {
    for (const std::string name : {"NodeData", "ElementData", "ElementNodeData"}) {
      const std::string data = data_section(name, false, components, entries, 0.5, "");
      check_read(name + " of " + std::to_string(entries) + " times " + std::to_string(components),
                 replaced(sample_content("v2_little.msh"), "$EndMeshFormat\n", "$EndMeshFormat\n" + data + data));
    }
  }
}

TEST_CASE("Gmsh: a section without an end affects only itself", "[mesh_io]") {
  for (const std::string file : {"v2.msh", "crlf.msh", "v4.msh", "v2_little.msh", "v4_big.msh"}) {
    const std::string end = file == "crlf.msh" ? "\r\n" : "\n", head = "$EndMeshFormat" + end,
                      open = "$Views" + end + "1 2 3" + end;
    CHECK(notes_mention(check_read(file + ", open section before", replaced(sample_content(file), head, head + open)),
                        "Section without an end: $Views"));
    CHECK(notes_mention(check_read(file + ", open section behind", sample_content(file) + open), "$Views"));
    check_read(file + ", two open ones", replaced(sample_content(file), head, head + open + open));
    check_read(file + ", end tag alone", replaced(sample_content(file), head, head + "$EndViews" + end));
    check_read(file + ", text",
               "# made by hand" + end + replaced(sample_content(file), head, head + "some text" + end + "$" + end));
  }
  // The end of a later section with the same name does not end an earlier one.
  const std::string twice = replaced(sample_content("v2.msh"), "$EndMeshFormat\n", "$EndMeshFormat\n$NodeData\n1\n");
  CHECK(notes_mention(check_read("NodeData with and without an end", twice), "Section without an end: $NodeData"));
}

TEST_CASE("Gmsh: the end tag of a section may be missing if its counts are met", "[mesh_io]") {
  for (const std::string file : {"v1.msh", "v2.msh", "v4.msh", "v2_big.msh", "v4_little.msh"}) {
    for (const std::string name : {"Nodes", "Elements", "PhysicalNames"}) {
      const std::string tag = file != "v1.msh"     ? "$End" + name + "\n"
                              : name == "Nodes"    ? "$ENDNOD\n"
                              : name == "Elements" ? "$ENDELM\n"
                                                   : "";
      if (tag.empty()) continue;
      CHECK(notes_mention(
          check_read(file + " without " + tag.substr(0, tag.size() - 1), replaced(sample_content(file), tag, "")),
          "is missing"));
    }
  }
  const std::string v2 = sample_content("v2.msh");
  CHECK(notes_mention(check_read("cut off behind the last element", v2.substr(0, v2.find("$EndElements"))), "cut off"));
}

TEST_CASE("Gmsh: extra numbers after an entity have no effect", "[mesh_io]") {
  const std::string v4 = sample_content("v4.msh");
  std::string all = v4;
  const std::size_t begin = all.find("$Entities\n") + 10, end = all.find("$EndEntities");
  std::string lines;
  for (const char c : all.substr(begin, end - begin)) lines += c == '\n' ? std::string(" 0\n") : std::string(1, c);
  all.replace(begin, end - begin, lines);
  for (const std::string& text : {all, replaced(v4, "1 0 0 0 1 1 1 1 3 1 1 \n", "1 0 0 0 1 1 1 1 3 1 1 0\n"),
                                  replaced(v4, "1 1 1 2\n", "1 1 1 2 0 0\n")}) {
    const MeshFile file = check_read("surplus", text);
    CHECK(file.mesh.regions == sample_mesh().regions);
    CHECK(file.mesh.groups == sample_mesh().groups);
    CHECK(notes_mention(file, "$Entities: more numbers"));
  }
  // The part of a file for a volume without groups, as written by meshers without entities.
  const MeshFile plain = read_mesh_content(
      "m.msh",
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 1\n1 0 0 0 1.5 1.5 1.5 0 0 0\n$EndEntities\n"
      "$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n"
      "$Elements\n2 2 1 2\n2 1 2 1\n1 1 3 2\n3 1 4 1\n2 1 2 3 4\n$EndElements");
  CHECK(plain.mesh.tets == std::vector<Tet>{{0, 1, 2, 3}});
  CHECK(plain.ignored.triangles == 1);
}

TEST_CASE("Gmsh: entities that are not one per line are read by number, and invalid ones are left out", "[mesh_io]") {
  const std::string v4 = sample_content("v4.msh");
  const std::size_t begin = v4.find("$Entities\n") + 10, end = v4.find("$EndEntities");
  std::string one_line = v4.substr(begin, end - begin), one_each = one_line;
  std::replace(one_line.begin(), one_line.end(), '\n', ' ');
  std::replace(one_each.begin(), one_each.end(), ' ', '\n');
  for (const std::string& list : {one_line + "\n", one_each}) {
    std::string text = v4;
    CHECK(check_read("free form", text.replace(begin, end - begin, list)).mesh.regions == sample_mesh().regions);
  }
  for (const std::string wrong : {"1 1 1 99999999999\n", "1 1 1 2\n1 nan here\n", "", "-1\n"}) {
    std::string text = v4;
    const MeshFile file = check_read("entities without sense", text.replace(begin, end - begin, wrong));
    CHECK(file.mesh.regions == std::vector<int>{0, 0});
    CHECK(notes_mention(file, "Section $Entities cannot be understood"));
  }
  std::string binary = sample_content("v4_little.msh");
  binary.replace(binary.find("$Entities\n") + 10, 8, Bytes().add(~std::uint64_t{0}).text);
  CHECK(notes_mention(check_read("binary entities without sense", binary), "Section $Entities cannot be understood"));
  CHECK(notes_mention(
      check_read("names without quotes", replaced(sample_content("v2.msh"), "2 11 \"clamp\"", "2 11 clamp")),
      "Section $PhysicalNames cannot be understood and is passed over: m.msh:7: $PhysicalNames: "
      "physical name is ' clamp'"));
}

TEST_CASE("Gmsh: parametric nodes of version 2", "[mesh_io]") {
  const std::string v2 = sample_content("v2.msh");
  const std::size_t begin = v2.find("$Nodes\n") + 9, end = v2.find("$EndNodes");
  std::string lines;
  for (const char c : v2.substr(begin, end - begin))
    lines += c == '\n' ? std::string(" 2 1 0.25 0.75\n") : std::string(1, c);
  std::string text = v2;
  text.replace(begin, end - begin, lines);
  check_read("text", replaced(replaced(text, "$Nodes", "$ParametricNodes"), "$EndNodes", "$EndParametricNodes"));

  for (const bool big_endian : {false, true}) {
    Bytes nodes(big_endian);
    nodes.add_text("$ParametricNodes\n6\n");
    const std::vector<int> tags{10, 3, 2000000000, 4, 5, 6}, dimensions{0, 1, 2, 3, 2, 1};
    for (std::size_t v = 0; v < tags.size(); ++v) {
      nodes.add(tags[v]);
      for (int k = 0; k < 3; ++k) nodes.add(sample_mesh().positions[v][k]);
      nodes.add(dimensions[v]).add(1);
      for (int k = 0; dimensions[v] < 3 && k < dimensions[v]; ++k) nodes.add(0.5);
    }
    nodes.add_text("$EndParametricNodes\n");
    std::string binary = sample_content(big_endian ? "v2_big.msh" : "v2_little.msh");
    const std::size_t from = binary.find("$Nodes"), to = binary.find("$Elements");
    check_read("binary", binary.replace(from, to - from, nodes.text));
  }
}

TEST_CASE("Gmsh: a missing section that a mesh needs is named", "[mesh_io]") {
  const std::string v2 = sample_content("v2.msh"), v4 = sample_content("v4_little.msh");
  const auto without = [](std::string text, const std::string& name) {
    const std::size_t from = text.find("$" + name), to = text.find("$End" + name) + 5 + name.size();
    return text.erase(from, to - from);
  };
  const std::string of_nodes = error_of("m.msh", without(v2, "Nodes")),
                    of_elements = error_of("m.msh", without(v2, "Elements"));
  const std::string of_binary = error_of("m.msh", without(v4, "Nodes")),
                    of_format = error_of("m.msh", without(v2, "MeshFormat"));
  const std::string misspelled = error_of("m.msh", replaced(replaced(v2, "$Nodes", "$Node"), "$EndNodes", "$EndNode"));
  for (const std::string& error : {of_nodes, of_elements, of_binary, of_format, misspelled})
    std::printf("%s\n", error.c_str());
  CHECK(of_nodes == "m.msh:11: $Elements: no section of nodes stands before it; expected $Nodes");
  CHECK_THAT(of_elements, Catch::EndsWith("has no section of elements; expected $Elements"));
  CHECK_THAT(of_binary, Catch::EndsWith(", $Elements: no section of nodes stands before it; expected $Nodes"));
  CHECK_THAT(of_format, Catch::EndsWith("$Nodes: stands before the format; expected $MeshFormat first"));
  CHECK_THAT(misspelled, Catch::EndsWith("no section of nodes stands before it; expected $Nodes"));
}

TEST_CASE("Gmsh: tags are found in one pass, for any number of sections without an end", "[mesh_io]") {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  for (int i = 0; i < 50000; ++i) text += "$Section" + std::to_string(i) + "\n$PhysicalNames\n0\n$EndPhysicalNames\n";
  const MeshFile file = check_read("50,000 sections without an end", text + sample_content("v2.msh"));
  CHECK(notes_mention(file, "and 49992 more; the file may be cut off"));
  const GmshTags tags("x$EndA$EndA\n$B\nx$B $C\n$EndB");
  CHECK(tags.find("$EndA", 0) == 6u);
  CHECK(tags.find("$B", 0) == 12u);
  CHECK(tags.find("$B", 13) == std::nullopt);
  CHECK(tags.find("$EndB", 3) == 22u);
}
