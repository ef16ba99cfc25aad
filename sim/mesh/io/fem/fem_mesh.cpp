#include "sim/mesh/io/fem/fem_mesh.h"

#include <algorithm>

namespace fascia {
namespace {

std::vector<std::int64_t> sorted(std::vector<std::int64_t> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

}  // namespace

void FemMesh::Place::fail(const std::string& what, const std::string& expected) const {
  Scanner there = *in;
  there.blame(at);
  there.fail(what, expected);
}

void FemMesh::add_node(const Scanner& in, std::int64_t number, const Eigen::Vector3d& x) {
  if (node_numbers_.empty()) first_node_ = place_of(in);
  check_vertex_count(in, node_numbers_.size() + 1);
  node_numbers_.push_back(number);
  file_.mesh.positions.push_back(x);
}

void FemMesh::add_element(const Scanner& in, const FemElement& kind, std::int64_t number,
                          std::span<const std::int64_t> nodes, int region) {
  if (elements_.empty()) first_element_ = place_of(in);
  element_numbers_.push_back(number);
  elements_.push_back({kind, region, nodes_.size(), place_of(in)});
  nodes_.insert(nodes_.end(), nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(kind.read()));
  higher_order_ |= kind.dimension >= 2 && kind.nodes > kind.corners;
}

std::vector<FemRange>& FemMesh::set(const Scanner& in, Of of, const std::string& name) {
  return sets_.try_emplace({of, name}, Set{{}, place_of(in)}).first->second.members;
}

const std::vector<FemRange>* FemMesh::find(Of of, const std::string& name) const {
  const auto found = sets_.find({of, name});
  return found == sets_.end() ? nullptr : &found->second.members;
}

void FemMesh::assign(TagMap& map, const Numbers& numbers, const char* what, const Place& first) const {
  if (const auto twice = map.assign(numbers))
    first.fail(std::string(what) + " " + std::to_string(numbers[*twice]) + " occurs twice in the list that begins here",
               "expected every number once");
}

template <class Use>
void FemMesh::for_members(const std::string& name, const Set& set, const char* what, const TagMap& map,
                          const Numbers& numbers, Use use) const {
  for (const FemRange& range : set.members) {
    if (range.first == range.last) {
      const auto index = map.find(range.first);
      if (!index)
        set.place.fail("set " + in_quotes(name) + " names " + what + " " + std::to_string(range.first),
                       std::string("expected ") + what + "s of the file");
      use(*index);
      continue;
    }
    // Of a range only the numbers that exist are visited: its bounds may be any numbers.
    for (auto number = std::lower_bound(numbers.begin(), numbers.end(), range.first);
         number != numbers.end() && *number <= range.last; ++number) {
      const std::uint64_t offset = static_cast<std::uint64_t>(*number) - static_cast<std::uint64_t>(range.first);
      if (offset % static_cast<std::uint64_t>(range.step) == 0) use(*map.find(*number));
    }
  }
}

void FemMesh::apply_regions(const TagMap& element_of) {
  const Numbers numbers = regions_.empty() ? Numbers() : sorted(element_numbers_);
  for (const auto& [name, region] : regions_) {
    const auto set = sets_.find({Of::elements, name});
    if (set == sets_.end()) continue;
    for_members(name, set->second, "element", element_of, numbers,
                [&, r = region](std::uint32_t element) { elements_[element].region = r; });
  }
}

void FemMesh::add_cells(const TagMap& node_of) {
  std::vector<std::uint32_t> vertices;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const Element& element = elements_[e];
    vertices.clear();
    for (std::size_t i = 0; i < element.kind.read(); ++i) {
      const std::int64_t node = nodes_[element.begin + i];
      const auto vertex = node_of.find(node);
      if (!vertex) {
        element.place.fail("element " + std::to_string(element_numbers_[e]) + " names node " + std::to_string(node),
                           "expected a node of the file");
      }
      vertices.push_back(*vertex);
    }
    const std::span<const std::uint32_t> corners(vertices.data(), element.kind.corners);
    if (element.kind.corners > 0 && element.kind.dimension == 3) {
      add_solid(file_, corners);
      const auto& v = vertices;
      if (element.kind.is_quadratic_tet()) set_mid_edges(file_, {v[4], v[5], v[6], v[7], v[8], v[9]});
      file_.mesh.regions.resize(file_.mesh.tets.size(), element.region);
    } else if (element.kind.corners > 0 && element.kind.dimension == 2) {
      add_face(file_, corners);
    } else {
      count_ignored(file_, element.kind.dimension, 0);
    }
  }
}

void FemMesh::add_groups(const TagMap& node_of, const TagMap& element_of) {
  const Numbers nodes = sorted(node_numbers_), elements = sorted(element_numbers_);
  for (const auto& [key, set] : sets_) {
    const auto& [of, name] = key;
    std::vector<std::uint32_t>& group = file_.mesh.groups[name];
    if (of == Of::nodes) {
      for_members(name, set, "node", node_of, nodes, [&](std::uint32_t node) { group.push_back(node); });
      continue;
    }
    for_members(name, set, "element", element_of, elements, [&](std::uint32_t index) {
      const Element& element = elements_[index];
      for (std::size_t i = 0; i < element.kind.corners; ++i) group.push_back(*node_of.find(nodes_[element.begin + i]));
    });
  }
}

void FemMesh::build() {
  TagMap node_of, element_of;
  assign(node_of, node_numbers_, "node", first_node_);
  assign(element_of, element_numbers_, "element", first_element_);
  apply_regions(element_of);
  add_cells(node_of);
  add_groups(node_of, element_of);
  std::erase_if(file_.mesh.groups, [](const auto& group) { return group.second.empty(); });
  if (higher_order_) file_.notes.push_back(kHigherOrderNote);
}

}  // namespace fascia
