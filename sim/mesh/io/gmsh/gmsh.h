// The common part of the readers of all Gmsh versions: physical groups, node tags and the handling of elements.
// File format: Gmsh reference manual, "Gmsh file formats".
#pragma once
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "sim/mesh/io/cell_split.h"
#include "sim/mesh/io/formats.h"
#include "sim/mesh/io/gmsh/gmsh_tags.h"
#include "sim/mesh/io/tag_map.h"

namespace fascia {

struct GmshElementType {
  int dimension = -1;  // -1: unknown type
  int nodes = 0;
  int corners = 0;  // the first nodes of an element are its corners
};
/// Table of Gmsh's element type numbers.
GmshElementType gmsh_element_type(int number);
inline constexpr int gmsh_max_nodes = 125;

using Physical = std::pair<int, int>;  // dimension and tag of a physical group

class GmshReader {
 public:
  GmshReader(Scanner& in, MeshFile& file) : in_(in), file_(file) {}
  void read();

 private:
  void read_format();
  void read_physical_names();
  void read_section(std::string_view name);
  void end_section(std::string_view name);
  void require_complete();

  void skip_section(std::string_view name);
  bool skip_by_counts(std::string_view name);
  void skip_stray_line(std::string_view word);
  void read_optional(std::string_view name, void (GmshReader::*reader)());
  void note_sections();

  void read_nodes_1_2(std::string_view section);
  void read_elements_1(std::string_view end);
  void read_elements_2_text();
  void read_elements_2_binary();

  void read_entities_4();
  void read_partitioned_entities_4();
  void read_entity_lists_4(bool partitioned);
  void read_entity_list_4(bool partitioned);
  void begin_entity_4();
  void end_entity_4();
  void read_entity_4(int dimension, bool partitioned);
  void read_nodes_4();
  void read_elements_4();

  // Version 4 files are the same sequence of numbers in text and in binary.
  std::int64_t integer(const char* what);   // int in binary
  std::uint64_t size(const char* what);     // size_t in binary
  std::int64_t mesh_tag(const char* what);  // of a node or an element
  std::size_t tag_bytes() const { return is_40_ ? sizeof(std::int32_t) : static_cast<std::size_t>(size_bytes_); }
  /// Dimension and number of the entity of a block.
  std::pair<std::int64_t, std::int64_t> block_entity(const char* dimension, const char* entity);
  double real(const char* what);
  double coordinate(const char* what);

  void begin_nodes(std::size_t count);
  void begin_elements();
  void name_nodes(const std::vector<std::int64_t>& tags);
  int physical_tag(std::int64_t tag) const;
  void add_element(const GmshElementType& type, std::int64_t element, std::span<const int> physicals,
                   std::span<const std::int64_t> nodes);
  void name_groups();

  Scanner& in_;
  MeshFile& file_;
  bool binary_ = false;
  int size_bytes_ = 8;  // of a size_t in a binary version 4 file
  int major_ = 1;
  bool is_40_ = false;
  bool line_each_ = false;  // every entity of a version 4 text file ends with its line
  bool has_format_ = false, has_nodes_ = false, has_elements_ = false, second_order_ = false;
  std::size_t nodes_at_ = 0;  // offset of the list
  TagMap node_of_tag_;
  std::map<Physical, std::string> names_;
  std::map<Physical, std::vector<std::uint32_t>> group_vertices_;
  Physical last_group_{-1, 0};
  std::vector<std::uint32_t>* last_vertices_ = nullptr;
  std::map<Physical, std::vector<int>> entity_physicals_;  // by dimension and tag of the entity

  std::optional<GmshTags> tags_;                 // created when needed
  std::set<std::string> passed_over_, endless_;  // sections
  bool has_stray_lines_ = false, wrong_counts_ = false, has_surplus_ = false;
};

}  // namespace fascia
