// A tree of boxes around things that move but keep their number, for finding those that overlap a box. Built once from
// the middles of the things by halves at the median of the longest side, then fitted to their boxes in every step.
#pragma once
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace fascia {

class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<Eigen::Vector3d>& middles);

  /// `boxes`: one for each thing, in the order of the middles.
  void fit(const std::vector<Eigen::AlignedBox3d>& boxes);
  const Eigen::AlignedBox3d& bounds() const { return nodes_.front().box; }  // of a tree that is not empty
  bool empty() const { return nodes_.empty(); }

  /// Calls found(thing) for those whose leaf overlaps `box`, in an order that depends on the tree alone.
  template <class F>
  void for_overlaps(const Eigen::AlignedBox3d& box, F&& found) const {
    if (empty()) return;
    std::uint32_t stack[kDeepest];
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const Node& node = nodes_[stack[--top]];
      if (!node.box.intersects(box)) continue;
      if (node.right == 0) {
        for (std::uint32_t k = node.begin; k < node.end; ++k) found(things_[k]);
        continue;
      }
      stack[top++] = node.right;
      stack[top++] = static_cast<std::uint32_t>(&node - nodes_.data()) + 1;
    }
  }

 private:
  static constexpr int kDeepest = 64;  // halves of a 32-bit count, and one more at each level
  struct Node {
    Eigen::AlignedBox3d box;
    std::uint32_t begin = 0, end = 0;  // of things_
    std::uint32_t right = 0;           // second child; the first one follows the node; 0: a leaf
  };
  void build(const std::vector<Eigen::Vector3d>& middles, std::uint32_t begin, std::uint32_t end);

  std::vector<Node> nodes_;  // parents before their children
  std::vector<std::uint32_t> things_;
};

}  // namespace fascia
