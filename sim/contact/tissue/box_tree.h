// A tree of boxes around things that move but keep their number, for finding those that overlap a box. Built once from
// the middles of the things by halves at the median of the longest side, then fitted to their boxes in every step.
//
// Things may face somewhere, as triangles do along their normals. A node then has a second box, around the normals
// below it, by which a search for what faces the other way leaves out whole patches of a surface: most of all those
// around the place that the search is for.
#pragma once
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace fascia {

class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<Eigen::Vector3d>& middles);

  /// `boxes`: one for each thing, in the order of the middles; `facings`, boxes around its normals, alike, or none.
  void fit(const std::vector<Eigen::AlignedBox3d>& boxes, const std::vector<Eigen::AlignedBox3d>& facings = {});
  const Eigen::AlignedBox3d& bounds() const { return nodes_.front().box; }  // of a tree that is not empty
  bool empty() const { return nodes_.empty(); }

  /// Calls found(thing) for those whose leaf overlaps `box`, in an order that depends on the tree alone.
  template <class F>
  void for_overlaps(const Eigen::AlignedBox3d& box, F&& found) const {
    visit([&](const Node& node) { return node.box.intersects(box); }, found);
  }
  /// The same without leaves in which nothing faces against `direction`. After a fit() with facings.
  template <class F>
  void for_opposed(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& direction, F&& found) const {
    const double rounding = 1e-12 * direction.lpNorm<1>();  // of the products, so that none is left out for it
    visit(
        [&](const Node& node) {
          if (!node.box.intersects(box)) return false;
          const Eigen::Array3d low = direction.array() * node.facing.min().array(),
                               high = direction.array() * node.facing.max().array();
          return !(low.min(high).sum() > rounding);
        },
        found);
  }

 private:
  static constexpr int kDeepest = 64;  // halves of a 32-bit count, and one more at each level
  struct Node {
    Eigen::AlignedBox3d box, facing;
    std::uint32_t begin = 0, end = 0;  // of things_
    std::uint32_t right = 0;           // second child; the first one follows the node; 0: a leaf
  };
  template <class Enters, class F>
  void visit(const Enters& enters, F&& found) const {
    if (empty()) return;
    std::uint32_t stack[kDeepest];
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const Node& node = nodes_[stack[--top]];
      if (!enters(node)) continue;
      if (node.right == 0) {
        for (std::uint32_t k = node.begin; k < node.end; ++k) found(things_[k]);
        continue;
      }
      stack[top++] = node.right;
      stack[top++] = static_cast<std::uint32_t>(&node - nodes_.data()) + 1;
    }
  }
  void build(const std::vector<Eigen::Vector3d>& middles, std::uint32_t begin, std::uint32_t end);

  std::vector<Node> nodes_;  // parents before their children
  std::vector<std::uint32_t> things_;
};

}  // namespace fascia
