#include "sim/contact/tissue/box_tree.h"

#include <algorithm>
#include <numeric>

namespace fascia {
namespace {

using Eigen::AlignedBox3d;

constexpr std::uint32_t kLeaf = 4;

}  // namespace

BoxTree::BoxTree(const std::vector<Eigen::Vector3d>& middles) : things_(middles.size()) {
  std::iota(things_.begin(), things_.end(), 0u);
  if (!middles.empty()) build(middles, 0, static_cast<std::uint32_t>(middles.size()));
}

void BoxTree::build(const std::vector<Eigen::Vector3d>& middles, std::uint32_t begin, std::uint32_t end) {
  const std::size_t place = nodes_.size();
  nodes_.push_back({{}, {}, begin, end, 0});
  if (end - begin <= kLeaf) return;
  AlignedBox3d box;
  for (std::uint32_t k = begin; k < end; ++k) box.extend(middles[things_[k]]);
  Eigen::Index longest = 0;
  box.sizes().maxCoeff(&longest);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(things_.begin() + begin, things_.begin() + middle, things_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double x = middles[a][longest], y = middles[b][longest];
                     return x != y ? x < y : a < b;
                   });
  build(middles, begin, middle);
  nodes_[place].right = static_cast<std::uint32_t>(nodes_.size());
  build(middles, middle, end);
}

void BoxTree::fit(const std::vector<AlignedBox3d>& boxes, const std::vector<AlignedBox3d>& facings) {
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    Node& node = nodes_[i];
    node.box.setEmpty();
    if (node.right == 0)
      for (std::uint32_t k = node.begin; k < node.end; ++k) node.box.extend(boxes[things_[k]]);
    else
      node.box.extend(nodes_[i + 1].box).extend(nodes_[node.right].box);
    if (facings.empty()) continue;
    node.facing.setEmpty();
    if (node.right == 0)
      for (std::uint32_t k = node.begin; k < node.end; ++k) node.facing.extend(facings[things_[k]]);
    else
      node.facing.extend(nodes_[i + 1].facing).extend(nodes_[node.right].facing);
  }
}

}  // namespace fascia
