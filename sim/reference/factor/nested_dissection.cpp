#include "sim/reference/factor/nested_dissection.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace fascia::reference {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kLeaf = 32;     // largest number of vertices that are not divided further
constexpr double kWorthTrying = 0.5;  // of the longest side: planes across shorter ones cut more

class Dissection {
 public:
  Dissection(const std::vector<std::vector<int>>& neighbors, const std::vector<Vector3d>& positions)
      : neighbors_(neighbors), positions_(positions), half_(positions.size(), 0) {
    tree_.place.resize(positions.size());
    std::vector<int> all(positions.size());
    std::iota(all.begin(), all.end(), 0);
    part(std::move(all));
  }
  EliminationTree tree() && { return std::move(tree_); }

 private:
  struct Cut {
    std::vector<int> left, right, between;
  };

  // Returns the topmost nodes of these vertices.
  std::vector<int> part(std::vector<int> vertices) {
    if (vertices.size() <= kLeaf) return {eliminate(vertices, {})};
    Cut cut = best_cut(std::move(vertices));
    std::vector<int> below = part(std::move(cut.left));
    const std::vector<int> right = part(std::move(cut.right));
    below.insert(below.end(), right.begin(), right.end());
    if (cut.between.empty()) return below;
    return {eliminate(cut.between, below)};
  }

  int eliminate(const std::vector<int>& vertices, const std::vector<int>& below) {
    const int node = static_cast<int>(tree_.nodes.size());
    for (const int child : below) tree_.nodes[child].parent = node;
    tree_.nodes.push_back({eliminated_, eliminated_ + static_cast<int>(vertices.size())});
    for (const int v : vertices) tree_.place[v] = eliminated_++;
    return node;
  }

  Cut best_cut(std::vector<int> vertices) {
    Vector3d low = positions_[vertices.front()], high = low;
    for (const int v : vertices) {
      low = low.cwiseMin(positions_[v]);
      high = high.cwiseMax(positions_[v]);
    }
    const Vector3d size = high - low;
    Cut best;
    for (int axis = 0; axis < 3; ++axis) {
      if (size[axis] < kWorthTrying * size.maxCoeff()) continue;
      Cut cut = cut_across(axis, vertices);
      if (best.left.empty() || cut.between.size() < best.between.size()) best = std::move(cut);
    }
    return best;
  }

  Cut cut_across(int axis, std::vector<int>& vertices) {
    auto middle = vertices.begin() + static_cast<std::ptrdiff_t>(vertices.size() / 2);
    std::nth_element(vertices.begin(), middle, vertices.end(), [&](int a, int b) {
      return std::pair(positions_[a][axis], a) < std::pair(positions_[b][axis], b);
    });
    // Vertices in one plane, such as a layer of a box, stay together if the halves remain of useful size.
    const auto is_before = [&, plane = positions_[*middle][axis]](int v) { return positions_[v][axis] < plane; };
    if (3 * static_cast<std::size_t>(std::count_if(vertices.begin(), vertices.end(), is_before)) >= vertices.size())
      middle = std::partition(vertices.begin(), vertices.end(), is_before);
    const int left = ++marks_, right = ++marks_;
    for (auto v = vertices.begin(); v != vertices.end(); ++v) half_[*v] = v < middle ? left : right;
    const auto touches = [&](int v, int other) {
      return std::any_of(neighbors_[v].begin(), neighbors_[v].end(), [&](int w) { return half_[w] == other; });
    };
    Cut cut;
    std::vector<int> edge_of_left, edge_of_right;
    for (const int v : vertices) {
      const bool is_left = half_[v] == left;
      if (touches(v, is_left ? right : left)) (is_left ? edge_of_left : edge_of_right).push_back(v);
    }
    cut.between = edge_of_left.size() <= edge_of_right.size() ? std::move(edge_of_left) : std::move(edge_of_right);
    const int between = ++marks_;
    for (const int v : cut.between) half_[v] = between;
    for (const int v : vertices)
      if (half_[v] != between) (half_[v] == left ? cut.left : cut.right).push_back(v);
    return cut;
  }

  const std::vector<std::vector<int>>& neighbors_;
  const std::vector<Vector3d>& positions_;
  std::vector<int> half_;  // [vertex] mark of the half that last contained it
  int marks_ = 0, eliminated_ = 0;
  EliminationTree tree_;
};

}  // namespace

EliminationTree nested_dissection(const std::vector<std::vector<int>>& neighbors,
                                  const std::vector<Vector3d>& positions) {
  if (positions.empty()) return {};
  return Dissection(neighbors, positions).tree();
}

}  // namespace fascia::reference
