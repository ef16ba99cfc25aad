// The order of elimination: every vertex once, neighbors on one branch of the tree, small separators.
#include "sim/reference/factor/nested_dissection.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "tests/sim/reference/box_model.h"

namespace fascia::reference {
namespace {

using Eigen::Vector3d;

// The boxes share no vertex.
Model separate_boxes() {
  Model model = test::box_model(9, 4, 4, {0.9, 0.4, 0.4}, test::soft(1e5));
  const Model other = test::box_model(3, 4, 5, {0.3, 0.4, 0.5}, test::soft(1e5));
  const auto first = static_cast<std::uint32_t>(model.rest_positions.size());
  for (const Vector3d& x : other.rest_positions) model.rest_positions.push_back(x + Vector3d(2, 0, 0));
  for (const Tet& tet : other.tets)
    model.tets.push_back({tet[0] + first, tet[1] + first, tet[2] + first, tet[3] + first});
  return model;
}

TEST_CASE("a vertex's neighbors are in its own node, above or below, whatever the shape") {
  const auto shape = GENERATE(0, 1, 2, 3);
  Model model = test::box_model(40, 3, 3, {4, 0.3, 0.3}, test::soft(1e5));
  if (shape != 1) model = separate_boxes();
  std::vector<std::vector<int>> neighbors(model.rest_positions.size());
  for (const Tet& tet : model.tets)
    for (const std::uint32_t v : tet)
      for (const std::uint32_t w : tet)
        if (v != w) neighbors[v].push_back(static_cast<int>(w));
  if (shape == 2)
    std::fill(model.rest_positions.begin(), model.rest_positions.end(), Vector3d(1, 2, 3));  // all at one point
  if (shape == 3)
    for (Vector3d& x : model.rest_positions) x.z() = x.y() = 0;  // on a line
  const EliminationTree tree = nested_dissection(neighbors, model.rest_positions);

  std::vector<int> node_of(neighbors.size(), -1);
  int next = 0;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    REQUIRE(tree.nodes[n].begin == next);
    next = tree.nodes[n].end;
    REQUIRE((tree.nodes[n].parent == -1 || tree.nodes[n].parent > static_cast<int>(n)));
    for (int place = tree.nodes[n].begin; place < next; ++place) node_of[place] = static_cast<int>(n);
  }
  REQUIRE(next == static_cast<int>(neighbors.size()));
  CHECK(std::set<int>(tree.place.begin(), tree.place.end()).size() == neighbors.size());
  const auto is_above = [&](int node, int other) {
    while (node >= 0 && node != other) node = tree.nodes[node].parent;
    return node == other;
  };
  int strangers = 0;
  for (std::size_t v = 0; v < neighbors.size(); ++v)
    for (const int w : neighbors[v]) {
      const int a = node_of[tree.place[v]], b = node_of[tree.place[w]];
      strangers += !is_above(a, b) && !is_above(b, a);
    }
  CHECK(strangers == 0);
  if (shape == 1) {  // a beam is cut crosswise
    REQUIRE(tree.nodes.back().parent == -1);
    CHECK(tree.nodes.back().end - tree.nodes.back().begin == 16);
  }
}

TEST_CASE("no vertices give an empty tree, and a few give one node") {
  CHECK(nested_dissection({}, {}).nodes.empty());
  const EliminationTree one = nested_dissection({{1}, {0}, {}}, {{0, 0, 0}, {1, 0, 0}, {5, 0, 0}});
  REQUIRE(one.nodes.size() == 1);
  CHECK(one.nodes[0].begin == 0);
  CHECK(one.nodes[0].end == 3);
  CHECK(one.nodes[0].parent == -1);
}

TEST_CASE("single vertices divide a chain into pieces of a few") {
  constexpr int kLength = 1000;
  std::vector<std::vector<int>> neighbors(kLength);
  std::vector<Vector3d> positions;
  for (int v = 0; v < kLength; ++v) {
    positions.emplace_back(v, 0, 0);
    if (v > 0) neighbors[v].push_back(v - 1);
    if (v + 1 < kLength) neighbors[v].push_back(v + 1);
  }
  const EliminationTree tree = nested_dissection(neighbors, positions);
  std::vector<char> has_children(tree.nodes.size(), 0);
  for (const EliminationTree::Node& node : tree.nodes)
    if (node.parent >= 0) has_children[node.parent] = 1;
  int largest_leaf = 0, largest_separator = 0;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    int& largest = has_children[n] ? largest_separator : largest_leaf;
    largest = std::max(largest, tree.nodes[n].end - tree.nodes[n].begin);
  }
  CAPTURE(tree.nodes.size(), largest_leaf, largest_separator);
  CHECK(largest_separator == 1);
  CHECK(largest_leaf <= 32);
  CHECK(tree.nodes.size() > kLength / 32);
}

}  // namespace
}  // namespace fascia::reference
