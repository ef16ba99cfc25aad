// Nodes, elements and sets of finite element files by their numbers, in any order: what Abaqus, FEBio and Vega files
// have in common. Sets become groups of vertices.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "sim/mesh/io/cell_split.h"
#include "sim/mesh/io/formats.h"
#include "sim/mesh/io/tag_map.h"

namespace fascia {

/// A kind of element. Its corners are the first of its nodes.
struct FemElement {
  int dimension = 3;
  std::size_t corners = 0, nodes = 0;  // 0: a kind that is counted, not read

  /// Tets of 15 nodes have those of the faces and of the middle behind the ten.
  bool is_quadratic_tet() const { return dimension == 3 && corners == 4 && (nodes == 10 || nodes == 15); }
  std::size_t read() const { return is_quadratic_tet() ? 10 : corners; }  // of its nodes
};

/// The numbers `first`, `first + step`, ... up to `last`; one number if both are equal.
struct FemRange {
  std::int64_t first, last, step;
};

class FemMesh {
 public:
  explicit FemMesh(MeshFile& file) : file_(file) {}

  /// `in` stands behind what is added, and must outlive this: errors about it are found in build().
  void add_node(const Scanner& in, std::int64_t number, const Eigen::Vector3d& x);
  void add_element(const Scanner& in, const FemElement& kind, std::int64_t number, std::span<const std::int64_t> nodes,
                   int region);

  enum class Of { nodes, elements };
  /// Adds to the set of this name, which is created if it is new.
  std::vector<FemRange>& set(const Scanner& in, Of of, const std::string& name);
  /// The members of an earlier set; null if there is none.
  const std::vector<FemRange>* find(Of of, const std::string& name) const;
  /// Gives the elements of a set this region; in the order of the calls.
  void set_region(const std::string& element_set, int region) { regions_.emplace_back(element_set, region); }

  /// Adds cells and groups to the file. Throws Error for numbers that are there twice or name nothing. A range may have
  /// gaps.
  void build();
  /// Builds and finishes the file.
  void finish(const std::string& where) {
    build();
    finish_mesh(file_, where);
  }

 private:
  struct Place {
    const Scanner* in;
    std::size_t at;
    [[noreturn]] void fail(const std::string& what, const std::string& expected) const;
  };
  struct Element {
    FemElement kind;
    int region;
    std::size_t begin;  // its first node in nodes_
    Place place;
  };
  struct Set {
    std::vector<FemRange> members;
    Place place;
  };
  using Numbers = std::vector<std::int64_t>;

  static Place place_of(const Scanner& in) { return {&in, in.offset()}; }
  void assign(TagMap& map, const Numbers& numbers, const char* what, const Place& first) const;
  /// Calls use(index) for every member; `sorted` are the numbers that `map` knows.
  template <class Use>
  void for_members(const std::string& name, const Set& set, const char* what, const TagMap& map, const Numbers& sorted,
                   Use use) const;
  void add_cells(const TagMap& node_of);
  void add_groups(const TagMap& node_of, const TagMap& element_of);
  void apply_regions(const TagMap& element_of);

  MeshFile& file_;
  Numbers node_numbers_, element_numbers_;
  std::vector<Element> elements_;
  Numbers nodes_;  // of all elements
  Place first_node_{}, first_element_{};
  std::map<std::pair<Of, std::string>, Set> sets_;
  std::vector<std::pair<std::string, int>> regions_;
  bool higher_order_ = false;
};

}  // namespace fascia
