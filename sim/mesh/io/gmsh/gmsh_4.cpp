// Gmsh .msh 4.1 and 4.0: nodes and elements in blocks by geometric entity; the entities have the physical tags. Version
// 4.0 has a box for points, too, no smallest and largest tags, the entity of a block before its dimension, and the tag
// of a node, an int, before its coordinates.
#include <array>

#include "base/error.h"
#include "sim/mesh/io/gmsh/gmsh.h"

namespace fascia {

std::int64_t GmshReader::integer(const char* what) {
  if (binary_) return in_.binary<std::int32_t>(what);
  return line_each_ ? in_.number_on_line<std::int64_t>(what) : in_.number<std::int64_t>(what);
}

std::uint64_t GmshReader::size(const char* what) {
  if (!binary_) return line_each_ ? in_.number_on_line<std::uint64_t>(what) : in_.number<std::uint64_t>(what);
  return size_bytes_ == 8 ? in_.binary<std::uint64_t>(what) : in_.binary<std::uint32_t>(what);
}

std::int64_t GmshReader::mesh_tag(const char* what) {
  return is_40_ ? integer(what) : static_cast<std::int64_t>(size(what));
}

std::pair<std::int64_t, std::int64_t> GmshReader::block_entity(const char* dimension, const char* entity) {
  const std::int64_t first = integer(is_40_ ? entity : dimension), second = integer(is_40_ ? dimension : entity);
  return is_40_ ? std::pair(second, first) : std::pair(first, second);
}

double GmshReader::real(const char* what) {
  if (binary_) return in_.binary<double>(what);
  return line_each_ ? in_.number_on_line<double>(what) : in_.number<double>(what);
}

double GmshReader::coordinate(const char* what) { return binary_ ? in_.binary_coordinate(what) : in_.coordinate(what); }

void GmshReader::read_entity_4(int dimension, bool partitioned) {
  const auto tag = static_cast<int>(integer("an entity tag"));
  std::vector<int> physicals;
  if (partitioned) {
    const auto parent_dimension = static_cast<int>(integer("the dimension of a parent entity"));
    const auto parent = entity_physicals_.find({parent_dimension, static_cast<int>(integer("a parent entity"))});
    if (parent != entity_physicals_.end() && parent_dimension == dimension) physicals = parent->second;
    const std::uint64_t partitions = size("a number of partitions");
    in_.check_count(partitions, "partitions of an entity", binary_ ? 4 : 2);
    for (std::uint64_t i = 0; i < partitions; ++i) integer("a partition");
  }
  for (int i = 0; i < (dimension == 0 && !is_40_ ? 3 : 6); ++i) real("a bound of an entity");
  const std::uint64_t count = size("a number of physical tags");
  in_.check_count(count, "physical tags of an entity", binary_ ? 4 : 2);
  if (count > 0) physicals.clear();
  for (std::uint64_t i = 0; i < count; ++i) physicals.push_back(physical_tag(integer("a physical tag")));
  if (dimension > 0) {
    const std::uint64_t bounding = size("a number of bounding entities");
    in_.check_count(bounding, "bounding entities", binary_ ? 4 : 2);
    for (std::uint64_t i = 0; i < bounding; ++i) integer("a bounding entity");
  }
  if (!physicals.empty()) entity_physicals_[{dimension, tag}] = std::move(physicals);
}

void GmshReader::begin_entity_4() {
  if (line_each_) in_.at_end();  // to the next line that is not empty
}

void GmshReader::end_entity_4() {
  if (!line_each_) return;
  has_surplus_ |= !in_.at_line_end();
  in_.line();
}

void GmshReader::read_entities_4() { read_entity_lists_4(false); }
void GmshReader::read_partitioned_entities_4() { read_entity_lists_4(true); }

/// Some writers append extra numbers to an entity, and Gmsh reads by number, not by line. The lists are first read line
/// by line, which reveals extra numbers, else number by number.
void GmshReader::read_entity_lists_4(bool partitioned) {
  const Scanner before = in_;
  const auto physicals = entity_physicals_;
  for (const bool line_each : {!binary_, false}) {
    in_ = before;
    line_each_ = line_each;
    has_surplus_ = false;
    try {
      read_entity_list_4(partitioned);
      break;
    } catch (const Error&) {
      entity_physicals_ = physicals;
      if (!line_each) throw;
    }
  }
  line_each_ = false;
  if (has_surplus_)
    file_.notes.push_back(std::string(partitioned ? "$PartitionedEntities" : "$Entities") +
                          ": more numbers than an entity has, passed over.");
}

void GmshReader::read_entity_list_4(bool partitioned) {
  if (binary_) in_.end_line(partitioned ? "$PartitionedEntities" : "$Entities");
  if (partitioned) {
    begin_entity_4();
    size("the number of partitions");
    end_entity_4();
    begin_entity_4();
    const std::uint64_t ghosts = size("the number of ghost entities");
    end_entity_4();
    in_.check_count(ghosts, "ghost entities", binary_ ? 8 : 4);
    for (std::uint64_t i = 0; i < ghosts; ++i) {
      begin_entity_4();
      integer("a ghost entity");
      integer("the partition of a ghost entity");
      end_entity_4();
    }
  }
  std::array<std::uint64_t, 4> counts{};
  begin_entity_4();
  for (std::uint64_t& count : counts) {
    count = size("a number of entities");
    in_.check_count(count, "entities", binary_ ? 32 : 8);
  }
  end_entity_4();
  for (int dimension = 0; dimension < 4; ++dimension) {
    for (std::uint64_t i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) {
      begin_entity_4();
      read_entity_4(dimension, partitioned);
      end_entity_4();
    }
  }
  end_section(partitioned ? "$EndPartitionedEntities" : "$EndEntities");
}

void GmshReader::read_nodes_4() {
  if (binary_) in_.end_line("$Nodes");
  const std::uint64_t blocks = size("the number of node blocks");
  const std::uint64_t count = size("the number of nodes");
  in_.check_count(count, "nodes", binary_ ? 24 + tag_bytes() : 8);
  begin_nodes(count);
  for (int i = 0; i < 2 && !is_40_; ++i) size("the smallest and largest node tag");
  std::vector<std::int64_t> tags;
  tags.reserve(count);
  for (std::uint64_t b = 0; b < blocks; ++b) {
    const std::int64_t dimension = block_entity("the dimension of a node block", "the entity of a node block").first;
    if (dimension < 0 || dimension > 3)
      in_.fail("dimension of a node block is " + std::to_string(dimension), "expected 0 to 3");
    const bool parametric = integer("the parametric flag of a node block") != 0;
    const std::uint64_t in_block = size("the number of nodes of a block");
    if (in_block > count - tags.size()) {
      in_.fail("block of " + std::to_string(in_block) + " nodes",
               "expected at most " + std::to_string(count - tags.size()));
    }
    const std::int64_t parameters = !parametric || (is_40_ && dimension == 3) ? 0 : dimension;
    for (std::uint64_t i = 0; i < in_block && !is_40_; ++i) tags.push_back(mesh_tag("a node tag"));
    for (std::uint64_t i = 0; i < in_block; ++i) {
      if (is_40_) tags.push_back(mesh_tag("a node tag"));
      Eigen::Vector3d x;
      for (int k = 0; k < 3; ++k) x[k] = coordinate("a node coordinate");
      file_.mesh.positions.push_back(x);
      for (std::int64_t k = 0; k < parameters; ++k) real("a parametric coordinate");
    }
  }
  if (tags.size() != count) {
    in_.fail("blocks hold " + std::to_string(tags.size()) + " nodes", "expected " + std::to_string(count));
  }
  end_section("$EndNodes");
  name_nodes(tags);
}

void GmshReader::read_elements_4() {
  begin_elements();
  if (binary_) in_.end_line("$Elements");
  const std::uint64_t blocks = size("the number of element blocks");
  const std::uint64_t count = size("the number of elements");
  in_.check_count(count, "elements", binary_ ? 2 * tag_bytes() : 4);
  for (int i = 0; i < 2 && !is_40_; ++i) size("the smallest and largest element tag");
  std::array<std::int64_t, gmsh_max_nodes> nodes{};
  std::uint64_t done = 0;
  for (std::uint64_t b = 0; b < blocks; ++b) {
    const auto block = block_entity("the dimension of an element block", "the entity of an element block");
    const auto dimension = static_cast<int>(block.first), entity = static_cast<int>(block.second);
    const auto number = static_cast<int>(integer("an element type"));
    const GmshElementType type = gmsh_element_type(number);
    if (type.dimension < 0) in_.fail("element type is " + std::to_string(number), "expected a Gmsh element type");
    if (type.dimension != dimension) {
      in_.fail("element type " + std::to_string(number) + " in a block of dimension " + std::to_string(dimension),
               "expected dimension " + std::to_string(type.dimension));
    }
    const std::uint64_t in_block = size("the number of elements of a block");
    if (in_block > count - done) {
      in_.fail("block of " + std::to_string(in_block) + " elements",
               "expected at most " + std::to_string(count - done));
    }
    const auto found = entity_physicals_.find({dimension, entity});
    const std::span<const int> physicals =
        found != entity_physicals_.end() ? std::span<const int>(found->second) : std::span<const int>();
    const auto node_count = static_cast<std::size_t>(type.nodes);
    for (std::uint64_t e = 0; e < in_block; ++e) {
      const std::int64_t element = mesh_tag("an element tag");
      for (std::size_t i = 0; i < node_count; ++i) nodes[i] = mesh_tag("a node of an element");
      add_element(type, element, physicals, {nodes.data(), node_count});
    }
    done += in_block;
  }
  if (done != count) in_.fail("blocks hold " + std::to_string(done) + " elements", "expected " + std::to_string(count));
  end_section("$EndElements");
}

}  // namespace fascia
