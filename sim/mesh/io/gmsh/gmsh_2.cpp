// Gmsh .msh 1.0 and 2.x: one list of nodes, and one list of elements with their physical tags. In a parametric node the
// entity follows the coordinates, and then the parameters if that is a curve (one) or a surface (two).
#include <array>

#include "sim/mesh/io/gmsh/gmsh.h"

namespace fascia {

void GmshReader::read_nodes_1_2(std::string_view section) {
  const bool parametric = section == "$ParametricNodes";
  const std::size_t count = in_.count("nodes", binary_ ? 28 : 8);
  begin_nodes(count);
  if (binary_) in_.end_line("the number of nodes");
  std::vector<std::int64_t> tags(count);
  for (std::int64_t& tag : tags) {
    Eigen::Vector3d x;
    if (binary_) {
      tag = in_.binary<std::int32_t>("a node tag");
      for (int k = 0; k < 3; ++k) x[k] = in_.binary_coordinate("a node coordinate");
      if (parametric) {
        const auto dimension = in_.binary<std::int32_t>("the dimension of a node's entity");
        in_.skip(sizeof(std::int32_t), "a node's entity");
        if (dimension == 1 || dimension == 2)
          in_.skip(sizeof(double) * static_cast<std::uint64_t>(dimension), "a parametric coordinate");
      }
    } else {
      tag = in_.number<std::int64_t>("a node tag");
      for (int k = 0; k < 3; ++k) x[k] = in_.coordinate_on_line("a node coordinate");
      if (parametric)
        in_.line();
      else
        in_.end_line("the node coordinates");
    }
    file_.mesh.positions.push_back(x);
  }
  end_section(gmsh_end_tag(section));
  name_nodes(tags);
}

void GmshReader::read_elements_1(std::string_view end) {
  begin_elements();
  const std::size_t count = in_.count("elements", 12);
  std::array<std::int64_t, gmsh_max_nodes> nodes{};
  for (std::size_t e = 0; e < count; ++e) {
    const auto element = in_.number<std::int64_t>("an element number");
    const int number = in_.number_on_line<int>("an element type");
    const GmshElementType type = gmsh_element_type(number);
    if (type.dimension < 0) in_.fail("element type is " + std::to_string(number), "expected a Gmsh element type");
    const int physical = physical_tag(in_.number_on_line<std::int64_t>("a physical tag"));
    in_.number_on_line<std::int64_t>("an elementary tag");
    const int node_count = in_.number_on_line<int>("a number of nodes");
    if (node_count != type.nodes) {
      in_.fail("element has " + std::to_string(node_count) + " nodes",
               "expected " + std::to_string(type.nodes) + " for its type");
    }
    for (int i = 0; i < node_count; ++i)
      nodes[static_cast<std::size_t>(i)] = in_.number_on_line<std::int64_t>("a node of an element");
    add_element(type, element, {&physical, 1}, {nodes.data(), static_cast<std::size_t>(node_count)});
    in_.end_line("the nodes of an element");
  }
  end_section(end);
}

void GmshReader::read_elements_2_text() {
  begin_elements();
  const std::size_t count = in_.count("elements", 8);
  std::array<std::int64_t, gmsh_max_nodes> nodes{};
  for (std::size_t e = 0; e < count; ++e) {
    const auto element = in_.number<std::int64_t>("an element number");
    const int number = in_.number_on_line<int>("an element type");
    const GmshElementType type = gmsh_element_type(number);
    if (type.dimension < 0) in_.fail("element type is " + std::to_string(number), "expected a Gmsh element type");
    const auto tag_count = in_.number_on_line<unsigned>("a number of tags");
    int physical = 0;
    for (unsigned i = 0; i < tag_count; ++i) {
      const auto tag = in_.number_on_line<std::int64_t>("a tag of an element");
      if (i == 0) physical = physical_tag(tag);
    }
    const auto node_count = static_cast<std::size_t>(type.nodes);
    for (std::size_t i = 0; i < node_count; ++i) nodes[i] = in_.number_on_line<std::int64_t>("a node of an element");
    add_element(type, element, {&physical, 1}, {nodes.data(), node_count});
    in_.end_line("the nodes of an element");
  }
  end_section("$EndElements");
}

void GmshReader::read_elements_2_binary() {
  begin_elements();
  const std::size_t count = in_.count("elements", 8);
  in_.end_line("the number of elements");
  std::array<std::int64_t, gmsh_max_nodes> nodes{};
  for (std::size_t done = 0; done < count;) {
    const int number = in_.binary<std::int32_t>("an element type");
    const GmshElementType type = gmsh_element_type(number);
    if (type.dimension < 0) in_.fail("element type is " + std::to_string(number), "expected a Gmsh element type");
    const int block = in_.binary<std::int32_t>("a number of elements of one type");
    if (block < 1 || static_cast<std::size_t>(block) > count - done) {
      in_.fail("block of " + std::to_string(block) + " elements", "expected 1 to " + std::to_string(count - done));
    }
    const int tag_count = in_.binary<std::int32_t>("a number of tags");
    if (tag_count < 0) in_.fail("number of tags is " + std::to_string(tag_count), "expected 0 or more");
    const auto node_count = static_cast<std::size_t>(type.nodes);
    for (int e = 0; e < block; ++e) {
      const int element = in_.binary<std::int32_t>("an element number");
      int physical = 0;
      if (tag_count > 0) {
        physical = physical_tag(in_.binary<std::int32_t>("a physical tag"));
        in_.skip(4 * (static_cast<std::uint64_t>(tag_count) - 1), "the tags of an element");
      }
      for (std::size_t i = 0; i < node_count; ++i) nodes[i] = in_.binary<std::int32_t>("a node of an element");
      add_element(type, element, {&physical, 1}, {nodes.data(), node_count});
    }
    done += static_cast<std::size_t>(block);
  }
  end_section("$EndElements");
}

}  // namespace fascia
