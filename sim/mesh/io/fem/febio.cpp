// FEBio .feb (specification 1.2 to 4.0): XML with lists of nodes, blocks of elements, and sets of both. Blocks are
// regions: numbered from 1 and named as in the file, or by the numbers of their materials where elements state them.
#include <algorithm>
#include <map>
#include <optional>

#include "sim/mesh/io/fem/fem_mesh.h"
#include "sim/mesh/io/xml.h"

namespace fascia {
namespace {

std::optional<FemElement> febio_element(std::string_view type) {
  static const std::map<std::string_view, FemElement> kinds = {
      {"tet4", {3, 4, 4}},     {"tet5", {3, 4, 5}},  {"tet10", {3, 4, 10}},  {"tet15", {3, 4, 15}},
      {"tet20", {3, 4, 20}},   {"pyra5", {3, 5, 5}}, {"pyra13", {3, 5, 13}}, {"penta6", {3, 6, 6}},
      {"penta15", {3, 6, 15}}, {"hex8", {3, 8, 8}},  {"hex20", {3, 8, 20}},  {"hex27", {3, 8, 27}},
      {"tri3", {2, 3, 3}},     {"tri6", {2, 3, 6}},  {"tri7", {2, 3, 7}},    {"tri10", {2, 3, 10}},
      {"quad4", {2, 4, 4}},    {"quad8", {2, 4, 8}}, {"quad9", {2, 4, 9}},   {"line2", {1, 2, 2}},
      {"line3", {1, 2, 3}}};
  // "TET10G4" and the like name an integration rule, too.
  std::string name;
  bool digits = false;
  for (const char c : type) {
    const bool digit = c >= '0' && c <= '9';
    if (digits && !digit) break;
    digits |= digit;
    name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  const auto found = kinds.find(name);
  return found == kinds.end() ? std::nullopt : std::optional(found->second);
}

class FebioReader {
 public:
  FebioReader(Scanner& in, MeshFile& file) : in_(in), root_(parse_xml(in)), file_(file), mesh_(file) {}

  void read() {
    file_.format = "FEBio " + root_.attribute("version", "without version");
    const XmlElement* geometry = root_.child("Mesh");
    if (!geometry) geometry = root_.child("Geometry");
    if (!geometry) fail_at(in_, root_, "has no element Mesh", "expected Mesh, or Geometry before version 3");
    if (const std::string from = geometry->attribute("from"); !from.empty())
      fail_at(in_, *geometry, "is in another file, " + in_quotes(from), "expected it in this one");
    for (const XmlElement& list : geometry->children) {
      if (list.name == "Nodes") read_nodes(list);
      if (list.name == "Elements") read_elements(list);
      if (list.name == "NodeSet") read_set(list, FemMesh::Of::nodes);
      if (list.name == "ElementSet") read_set(list, FemMesh::Of::elements);
      if (list.name == "Surface") read_surface(list);
      if (list.name == "Part" || list.name == "Instance")
        fail_at(in_, list, "parts and their instances are not read",
                "expected nodes and elements in " + geometry->name + " itself, as FEBio Studio saves them");
    }
    for (const auto& [set, of] : joined_) read_references(*set, of);
    mesh_.finish(in_.where());
  }

 private:
  /// A scanner over the text of an element that has no children.
  Scanner text_of(const XmlElement& element) {
    if (in_.data().substr(element.text_end).starts_with("<!"))
      fail_at(in_, element, "has a comment in its text", "expected numbers alone");
    Scanner text(in_.where(), in_.data().substr(0, element.text_end));
    text.seek(element.text_begin);
    text.set_section(element.name);
    text.skip_commas();
    return text;
  }

  std::int64_t number(const XmlElement& element, const char* key) {
    const std::string text = element.attribute(key);
    std::int64_t value = 0;
    const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc{} || stop != text.data() + text.size())
      fail_at(in_, element, std::string(key) + " is " + in_quotes(text), "expected a whole number");
    return value;
  }

  void require_end(Scanner& text, const char* what) {
    if (!text.at_end()) text.fail("something follows " + std::string(what), "expected the end of the element");
  }

  void read_nodes(const XmlElement& list) {
    const std::string name = list.attribute("name");
    for (const XmlElement& node : list.children) {
      const std::int64_t id = number(node, "id");
      Scanner text = text_of(node);
      Eigen::Vector3d x;
      for (int k = 0; k < 3; ++k) x[k] = text.coordinate("a node coordinate");
      require_end(text, "the node coordinates");
      add_at(node, [&] { mesh_.add_node(in_, id, x); });
      if (!name.empty()) mesh_.set(in_, FemMesh::Of::nodes, name).push_back({id, id, 1});
    }
  }

  /// Errors about what `add` adds name this element.
  template <class Add>
  void add_at(const XmlElement& element, Add add) {
    in_.seek(element.at);
    add();
  }

  void read_elements(const XmlElement& block) {
    const std::string type = block.attribute("type"), name = block.attribute("name");
    const int region = ++blocks_;
    bool own_regions = true;
    std::vector<std::int64_t> nodes;
    std::vector<FemRange>* group = nullptr;  // of a block of shells, which is no region
    for (const XmlElement& element : block.children) {
      // Version 1: every element is named after its kind and states its material.
      const std::string& kind_name = type.empty() ? element.name : type;
      const FemElement kind = febio_element(kind_name).value_or(FemElement{3, 0, 0});
      const std::int64_t id = number(element, "id");
      Scanner text = text_of(element);
      nodes.resize(kind.nodes);
      for (std::int64_t& node : nodes) node = text.number<std::int64_t>("a node of an element");
      if (kind.nodes > 0) require_end(text, "the nodes of an element");
      int of_element = region;
      if (!element.attribute("mat").empty()) {
        const std::int64_t material = number(element, "mat");
        if (!is_region(static_cast<double>(material)))
          fail_at(in_, element, "mat is " + std::to_string(material), "expected a 32-bit number");
        of_element = static_cast<int>(material);
        own_regions = false;
      }
      add_at(element, [&] { mesh_.add_element(in_, kind, id, nodes, of_element); });
      if (kind.dimension == 3 || name.empty()) continue;
      if (!group) group = &mesh_.set(in_, FemMesh::Of::elements, name);
      group->push_back({id, id, 1});
    }
    if (own_regions && !group && !name.empty() && !block.children.empty()) file_.mesh.region_names[region] = name;
  }

  /// Members are elements with an id, or a text of numbers since version 4. Those that are other sets, which may stand
  /// behind this one, are added at the end.
  void read_set(const XmlElement& list, FemMesh::Of of) {
    const std::string name = list.attribute("name");
    if (name.empty()) return;
    in_.seek(list.at);
    std::vector<FemRange>& set = mesh_.set(in_, of, name);
    for (const XmlElement& member : list.children) {
      if (is_reference(member)) continue;
      const std::int64_t id = number(member, "id");
      set.push_back({id, id, 1});
    }
    Scanner text = text_of(list);
    if (std::any_of(list.children.begin(), list.children.end(), is_reference) || text.peek_word().starts_with('@'))
      return joined_.emplace_back(&list, of), void();
    while (list.children.empty() && !text.at_end()) {
      const auto id = text.number<std::int64_t>("a member of a set");
      set.push_back({id, id, 1});
    }
  }

  static bool is_reference(const XmlElement& member) { return member.name == "node_set" || member.name == "elem_set"; }

  void read_references(const XmlElement& list, FemMesh::Of of) {
    const std::string name = list.attribute("name");
    for (const XmlElement& member : list.children) {
      if (is_reference(member)) add_set(list, of, name, of, member.attribute(member.name));
    }
    if (!list.children.empty()) return;
    std::string_view text = in_.data().substr(list.text_begin, list.text_end - list.text_begin);  // "@surface:skin"
    text = text.substr(text.find('@'));
    const bool of_elements = of == FemMesh::Of::elements || text.starts_with("@elem_set:");
    text = text.substr(std::min(text.find(':'), text.size() - 1) + 1);
    text = text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
    add_set(list, of, name, of_elements ? FemMesh::Of::elements : FemMesh::Of::nodes, std::string(text));
  }

  /// Adds the members of a set to the one of this name: nodes of its elements to a set of nodes, too.
  void add_set(const XmlElement& list, FemMesh::Of of, const std::string& name, FemMesh::Of of_other,
               const std::string& other) {
    const std::vector<FemRange>* const members = mesh_.find(of_other, other);
    if (!members || (of == of_other && name == other)) {
      file_.notes.push_back("Set " + in_quotes(name) + " refers to " + in_quotes(other) + ", which is left out of it.");
      return;
    }
    members_ += members->size();
    if (members_ > 4 * in_.data().size())  // sets of sets can double with every line
      fail_at(in_, list, "has sets of " + std::to_string(members_) + " members", "expected no more than four a byte");
    in_.seek(list.at);
    std::vector<FemRange>& set = mesh_.set(in_, of_other, name);
    set.insert(set.end(), members->begin(), members->end());
  }

  /// A surface is a list of faces: the group of their nodes.
  void read_surface(const XmlElement& list) {
    const std::string name = list.attribute("name");
    if (name.empty()) return;
    in_.seek(list.at);
    std::vector<FemRange>& set = mesh_.set(in_, FemMesh::Of::nodes, name);
    for (const XmlElement& face : list.children) {
      Scanner text = text_of(face);
      while (!text.at_end()) {
        const auto node = text.number<std::int64_t>("a node of a face");
        set.push_back({node, node, 1});
      }
    }
  }

  Scanner& in_;
  XmlElement root_;
  MeshFile& file_;
  FemMesh mesh_;
  int blocks_ = 0;
  std::vector<std::pair<const XmlElement*, FemMesh::Of>> joined_;  // sets that refer to others
  std::size_t members_ = 0;                                        // that sets have from others
};

}  // namespace

void read_febio(Scanner& in, MeshFile& file) { FebioReader(in, file).read(); }

}  // namespace fascia
