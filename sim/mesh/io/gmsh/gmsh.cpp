// Gmsh .msh: sections, physical names, and the handling of elements in all versions.
#include "sim/mesh/io/gmsh/gmsh.h"

#include <algorithm>
#include <array>
#include <limits>

namespace fascia {

GmshElementType gmsh_element_type(int number) {
  static constexpr std::array<GmshElementType, 32> table = {{
      {-1, 0, 0}, {1, 2, 2},  {2, 3, 3},  {2, 4, 4},  {3, 4, 4},  {3, 8, 8},  {3, 6, 6},  {3, 5, 5},
      {1, 3, 2},  {2, 6, 3},  {2, 9, 4},  {3, 10, 4}, {3, 27, 8}, {3, 18, 6}, {3, 14, 5}, {0, 1, 1},
      {2, 8, 4},  {3, 20, 8}, {3, 15, 6}, {3, 13, 5}, {2, 9, 3},  {2, 10, 3}, {2, 12, 3}, {2, 15, 3},
      {2, 15, 3}, {2, 21, 3}, {1, 4, 2},  {1, 5, 2},  {1, 6, 2},  {3, 20, 4}, {3, 35, 4}, {3, 56, 4},
  }};
  if (number == 92) return {3, 64, 8};
  if (number == 93) return {3, 125, 8};
  return number > 0 && number < static_cast<int>(table.size()) ? table[static_cast<std::size_t>(number)]
                                                               : GmshElementType{};
}

void read_gmsh(Scanner& in, MeshFile& file) { GmshReader(in, file).read(); }

void GmshReader::read() {
  file_.format = "Gmsh 1.0 ASCII";
  while (!in_.at_end()) {
    in_.set_section("");
    const std::string_view word = in_.peek_word();
    if (word.size() < 2 || word[0] != '$' || is_gmsh_end_tag(word)) {
      skip_stray_line(word);
      continue;
    }
    in_.word("a section");
    in_.set_section(word);
    read_section(word);
  }
  require_complete();
  if (second_order_) file_.notes.push_back(kHigherOrderNote);
  note_sections();
  name_groups();
  finish_mesh(file_, in_.where());
}

void GmshReader::require_complete() {
  in_.set_section("");
  if (!has_nodes_) in_.fail("has no section of nodes", major_ == 1 ? "expected $NOD" : "expected $Nodes");
  if (!has_elements_) in_.fail("has no section of elements", major_ == 1 ? "expected $ELM" : "expected $Elements");
}

void GmshReader::read_section(std::string_view name) {
  if (name == "$MeshFormat") return read_format();
  if (name == "$PhysicalNames") return read_optional(name, &GmshReader::read_physical_names);
  if (name == "$NOD") return read_nodes_1_2(name);
  if (name == "$ELM") return read_elements_1("$ENDELM");
  const bool nodes = name == "$Nodes" || (name == "$ParametricNodes" && major_ != 4), elements = name == "$Elements";
  if ((nodes || elements) && !has_format_) in_.fail("stands before the format", "expected $MeshFormat first");
  if (nodes) {
    major_ == 2 ? read_nodes_1_2(name) : read_nodes_4();
  } else if (elements) {
    major_ == 4 ? read_elements_4() : binary_ ? read_elements_2_binary() : read_elements_2_text();
  } else if (name == "$Entities" && major_ == 4) {
    read_optional(name, &GmshReader::read_entities_4);
  } else if (name == "$PartitionedEntities" && major_ == 4) {
    read_optional(name, &GmshReader::read_partitioned_entities_4);
  } else {
    skip_section(name);
  }
}

/// The counts of a section determine its end: its end tag may be missing.
void GmshReader::end_section(std::string_view name) {
  const std::string_view found = in_.peek_word();
  const bool missing = found.empty() || (found.size() > 1 && found[0] == '$' && !is_gmsh_end_tag(found));
  if (missing) {
    file_.notes.push_back(std::string(name) + " is missing; the file may be cut off.");
  } else if (found != name) {
    in_.fail(in_quotes(found) + " follows the last entry", "expected " + std::string(name));
  } else {
    in_.word("the end of the section");
  }
}

void GmshReader::read_format() {
  has_format_ = true;
  const std::string_view version = in_.word("the version");
  if (version.starts_with("2") && (version.size() == 1 || (version[1] == '.' && version <= "2.2"))) {
    major_ = 2;
  } else if (version == "4.1" || version == "4.0" || version == "4") {
    major_ = 4;
    is_40_ = version != "4.1";
  } else {
    in_.fail("is Gmsh format version " + in_quotes(version),
             "expected 1.0, 2.0 to 2.2, 4.0 or 4.1; 'gmsh FILE -save -format msh41' converts");
  }
  const int file_type = in_.number<int>("the file type");
  if (file_type != 0 && file_type != 1)
    in_.fail("the file type is " + std::to_string(file_type), "expected 0 (ASCII) or 1 (binary)");
  binary_ = file_type == 1;
  file_.format = "Gmsh " + std::string(version) + (binary_ ? " binary" : " ASCII");
  size_bytes_ = in_.number<int>("the data size");
  if (size_bytes_ != 8 && !(major_ == 4 && size_bytes_ == 4)) {
    in_.fail("the data size is " + std::to_string(size_bytes_), "expected 8");
  }
  in_.end_line("the data size");
  if (binary_) {
    in_.locate_by_byte();
    const int one = in_.binary<int>("the byte order mark");
    if (one != 1 && byte_swapped(one) != 1) in_.fail("the byte order mark is " + std::to_string(one), "expected 1");
    in_.set_swapped(one != 1);
  }
  end_section("$EndMeshFormat");
}

void GmshReader::read_physical_names() {
  const std::size_t count = in_.count("physical names", 6);
  for (std::size_t i = 0; i < count; ++i) {
    const int dimension = in_.number<int>("the dimension of a physical name");
    const int tag = in_.number<int>("the tag of a physical name");
    const std::string_view line = in_.line();
    const std::size_t open = line.find('"'), close = line.rfind('"');
    if (open == close) in_.fail("physical name is " + in_quotes(line), "expected a name in quotes");
    if (dimension < 0 || dimension > 3)
      in_.fail("physical name of dimension " + std::to_string(dimension), "expected 0 to 3");
    const std::string name(line.substr(open + 1, close - open - 1));
    if (!name.empty()) names_[{dimension, tag}] = name;
  }
  end_section("$EndPhysicalNames");
}

void GmshReader::begin_nodes(std::size_t count) {
  if (has_nodes_) in_.fail("is the second section of nodes", "expected one");
  has_nodes_ = true;
  nodes_at_ = in_.offset();
  check_vertex_count(in_, count);
  file_.mesh.positions.reserve(count);
}

void GmshReader::begin_elements() {
  if (!has_nodes_) in_.fail("no section of nodes stands before it", major_ == 1 ? "expected $NOD" : "expected $Nodes");
  has_elements_ = true;
}

void GmshReader::name_nodes(const std::vector<std::int64_t>& tags) {
  if (const auto twice = node_of_tag_.assign(tags)) {
    in_.blame(nodes_at_);
    in_.fail("node tag " + std::to_string(tags[*twice]) + " occurs twice, again as node number " +
                 std::to_string(*twice + 1),
             "expected every tag once");
  }
}

int GmshReader::physical_tag(std::int64_t tag) const {
  constexpr std::int64_t most = std::numeric_limits<int>::max();
  if (tag < -most || tag > most) in_.fail("physical tag " + std::to_string(tag), "expected a 32-bit number");
  return static_cast<int>(tag < 0 ? -tag : tag);  // a minus sign means that the group reverses the element
}

void GmshReader::add_element(const GmshElementType& type, std::int64_t element, std::span<const int> physicals,
                             std::span<const std::int64_t> nodes) {
  std::array<std::uint32_t, 10> vertices{};
  const auto corner_count = static_cast<std::size_t>(type.corners);
  const bool quadratic = type.dimension == 3 && type.corners == 4 && type.nodes == 10;
  for (std::size_t i = 0; i < (quadratic ? 10 : corner_count); ++i) {
    const auto vertex = node_of_tag_.find(nodes[i]);
    if (!vertex) {
      in_.fail("element " + std::to_string(element) + " names node " + std::to_string(nodes[i]),
               "expected a node of $Nodes");
    }
    vertices[i] = *vertex;
  }
  second_order_ |= type.dimension >= 2 && type.nodes > type.corners;
  const std::span<const std::uint32_t> cell(vertices.data(), corner_count);
  const bool solid = type.dimension == 3;
  if (solid) {
    add_solid(file_, cell);
    // Gmsh has the middle of edge 23 before that of 13.
    const auto& v = vertices;
    if (quadratic) set_mid_edges(file_, {v[4], v[5], v[6], v[7], v[9], v[8]});
    file_.mesh.regions.resize(file_.mesh.tets.size(), physicals.empty() ? 0 : physicals[0]);
  } else if (type.dimension == 2) {
    add_face(file_, cell);
  } else {
    count_ignored(file_, type.dimension, type.corners);
  }
  // The first physical group of a cell is the region of its tets, which finish_mesh makes a group.
  for (const int physical : physicals.subspan(solid && !physicals.empty() ? 1 : 0)) {
    if (physical == 0) continue;
    const Physical group{type.dimension, physical};
    if (group != last_group_) {
      last_group_ = group;
      last_vertices_ = &group_vertices_[group];
    }
    last_vertices_->insert(last_vertices_->end(), vertices.begin(), vertices.begin() + type.corners);
  }
}

void GmshReader::name_groups() {
  TetMesh& mesh = file_.mesh;
  for (const auto& [physical, name] : names_) {
    if (physical.first == 3) mesh.region_names[physical.second] = name;
  }
  for (const auto& [physical, vertices] : group_vertices_) {
    const auto named = names_.find(physical);
    std::vector<std::uint32_t>& group =
        mesh.groups[named != names_.end() ? named->second : std::to_string(physical.second)];
    group.insert(group.end(), vertices.begin(), vertices.end());
  }
}

}  // namespace fascia
