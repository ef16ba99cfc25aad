#include "sim/surface/surface_shells.h"

#include <algorithm>
#include <queue>

namespace fascia {
namespace {

constexpr std::uint32_t kShellsInLeaf = 4;  // shells

}  // namespace

ShellTree::ShellTree(std::vector<Shell> shells) : shells_(std::move(shells)) {
  if (!shells_.empty()) build(0, static_cast<std::uint32_t>(shells_.size()));
}

void ShellTree::build(std::uint32_t begin, std::uint32_t end) {
  const std::size_t at = nodes_.size();
  Node node{Eigen::AlignedBox3d(), 0, begin, end, 0};
  Eigen::AlignedBox3d spread;
  for (std::uint32_t i = begin; i < end; ++i) {
    node.box.extend(shells_[i].box);
    node.area = std::max(node.area, shells_[i].area);
    spread.extend(shells_[i].box.center());
  }
  nodes_.push_back(node);
  if (end - begin <= kShellsInLeaf) return;
  int axis = 0;
  spread.sizes().maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(shells_.begin() + begin, shells_.begin() + middle, shells_.begin() + end,
                   [&](const Shell& a, const Shell& b) {
                     const double x = a.box.center()[axis], y = b.box.center()[axis];
                     return x != y ? x < y : a.number < b.number;
                   });
  build(begin, middle);
  nodes_[at].right = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end);
}

std::uint32_t ShellTree::largest_around(const Eigen::AlignedBox3d& box, double area,
                                        const std::function<bool(std::uint32_t)>& holds) const {
  struct Entry {
    double area;
    std::uint32_t number;  // of a shell; kNone for a node, which precedes shells of its area
    std::uint32_t node;
    bool operator<(const Entry& other) const {
      if (area != other.area) return area < other.area;
      if ((number == kNone) != (other.number == kNone)) return other.number == kNone;
      return number > other.number;
    }
  };
  std::priority_queue<Entry> queue;
  const auto add_node = [&](std::uint32_t at) {
    if (nodes_[at].area > area && nodes_[at].box.contains(box)) queue.push({nodes_[at].area, kNone, at});
  };
  if (!nodes_.empty()) add_node(0);
  while (!queue.empty()) {
    const Entry entry = queue.top();
    queue.pop();
    if (entry.number != kNone) {
      if (holds(entry.number)) return entry.number;
      continue;
    }
    const Node& node = nodes_[entry.node];
    if (node.right != 0) {
      add_node(entry.node + 1);
      add_node(node.right);
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i)
      if (shells_[i].area > area && shells_[i].box.contains(box)) queue.push({shells_[i].area, shells_[i].number, 0});
  }
  return kNone;
}

}  // namespace fascia
