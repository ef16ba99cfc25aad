#include "sim/coarse/coarse_contact.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <span>

namespace fascia {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3f;
using Eigen::MatrixXf;

/// The coarse functions at points.
class PointFunctions {
 public:
  PointFunctions(const CoarseSpace& space, const std::vector<PointStiffness>& points) {
    for (const PointStiffness& point : points) add(space, point);
  }
  /// Nodes, ascending, and weights.
  std::span<const std::pair<std::uint32_t, double>> at(std::size_t point) const {
    return std::span(functions_).subspan(begin_[point], begin_[point + 1] - begin_[point]);
  }

 private:
  void add(const CoarseSpace& space, const PointStiffness& point) {
    const auto begin = static_cast<std::ptrdiff_t>(functions_.size());
    for (std::size_t k = 0; k < 4; ++k) {
      if (point.weights[k] == 0) continue;
      for (std::uint32_t e = space.begin[point.vertices[k]]; e < space.begin[point.vertices[k] + 1]; ++e) {
        const double weight = point.weights[k] * space.weight[e];
        const auto same = std::find_if(functions_.begin() + begin, functions_.end(),
                                       [&](const auto& function) { return function.first == space.node[e]; });
        if (same == functions_.end())
          functions_.emplace_back(space.node[e], weight);
        else
          same->second += weight;
      }
    }
    std::sort(functions_.begin() + begin, functions_.end());
    begin_.push_back(functions_.size());
  }

  std::vector<std::pair<std::uint32_t, double>> functions_;
  std::vector<std::size_t> begin_{0};
};

/// The nodes that feel most of the stiffness, ascending.
std::vector<std::uint32_t> stiffest_nodes(const std::vector<Matrix3d>& blocks) {
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < blocks.size(); ++node)
    if (blocks[node].trace() > 0) nodes.push_back(node);
  if (nodes.size() <= TouchedNodes::kMost) return nodes;
  std::stable_sort(nodes.begin(), nodes.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return blocks[a].trace() > blocks[b].trace(); });
  nodes.resize(TouchedNodes::kMost);
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace

TouchedNodes touched_nodes(const CoarseSpace& space, const std::vector<PointStiffness>& points,
                           const std::vector<Eigen::Quaternionf>& rotations, double h) {
  const PointFunctions functions(space, points);
  std::vector<Matrix3d> blocks(space.node_count, Matrix3d::Zero());
  for (std::size_t p = 0; p < points.size(); ++p)
    for (const auto& [node, weight] : functions.at(p)) blocks[node] += weight * weight * points[p].stiffness;
  TouchedNodes touched{stiffest_nodes(blocks), {}};
  touched.stiffness.resize(3 * static_cast<Index>(touched.nodes.size()));
  for (Index k = 0; k < touched.stiffness.size() / 3; ++k) {
    const std::uint32_t node = touched.nodes[static_cast<std::size_t>(k)];
    const Matrix3d axes = rotations[node].toRotationMatrix().cast<double>();
    touched.stiffness.segment<3>(3 * k) = (h * h * (axes.transpose() * blocks[node] * axes).diagonal()).cast<float>();
  }
  return touched;
}

MatrixXf stiffness_between(const std::vector<std::uint32_t>& nodes, const CoarseSpace& space,
                           const std::vector<PointStiffness>& points, const std::vector<Eigen::Quaternionf>& rotations,
                           double h) {
  constexpr Index kNowhere = -1;
  std::vector<Index> place(space.node_count, kNowhere);
  for (std::size_t k = 0; k < nodes.size(); ++k) place[nodes[k]] = static_cast<Index>(k);

  // Blocks on and above the diagonal, first in the axes of the world
  const Index size = 3 * static_cast<Index>(nodes.size());
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(size, size);
  const PointFunctions functions(space, points);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Matrix3d at_point = h * h * points[p].stiffness;
    for (const auto& [right, weight] : functions.at(p)) {
      const Index column = place[right];
      if (column == kNowhere) continue;
      const Matrix3d weighted = weight * at_point;
      for (const auto& [left, other] : functions.at(p)) {
        if (left > right) break;
        if (const Index row = place[left]; row != kNowhere) sums.block<3, 3>(3 * row, 3 * column) += other * weighted;
      }
    }
  }
  MatrixXf stiffness(size, size);
  std::vector<Matrix3f> axes;
  for (const std::uint32_t node : nodes) axes.push_back(rotations[node].toRotationMatrix());
  for (Index k = 0; k < size / 3; ++k)
    for (Index i = 0; i <= k; ++i) {
      const Matrix3f block = axes[static_cast<std::size_t>(i)].transpose() *
                             sums.block<3, 3>(3 * i, 3 * k).cast<float>() * axes[static_cast<std::size_t>(k)];
      stiffness.block<3, 3>(3 * i, 3 * k) = block;
      stiffness.block<3, 3>(3 * k, 3 * i) = block.transpose();
    }
  return stiffness;
}

MatrixXf push_back(const std::vector<std::uint32_t>& nodes, const MatrixXf& stiffness,
                   const std::function<float(Index, Index)>& inverse) {
  const Index size = stiffness.rows();
  MatrixXf compliance(size, size);
  for (Index i = 0; i < size; ++i)
    for (Index k = 0; k < size; ++k)
      compliance(i, k) = inverse(3 * nodes[static_cast<std::size_t>(i / 3)] + i % 3,
                                 3 * nodes[static_cast<std::size_t>(k / 3)] + k % 3);
  const MatrixXf both = MatrixXf::Identity(size, size) + stiffness * compliance;
  return both.partialPivLu().solve(stiffness);
}

bool alike(const TouchedNodes& a, const TouchedNodes& b, const std::function<float(Index)>& compliance) {
  constexpr float kSame = 0.1f;
  const auto held = [&](const TouchedNodes& touched, std::size_t k, Index axis) {
    const float product = touched.stiffness[3 * static_cast<Index>(k) + axis] *
                          compliance(3 * static_cast<Index>(touched.nodes[k]) + axis);
    return product / (1 + product);
  };
  float changed = 0, all = 0;
  for (std::size_t i = 0, k = 0; i < a.nodes.size() || k < b.nodes.size();) {
    const bool in_a = i < a.nodes.size() && (k == b.nodes.size() || a.nodes[i] <= b.nodes[k]);
    const bool in_b = k < b.nodes.size() && (i == a.nodes.size() || b.nodes[k] <= a.nodes[i]);
    for (Index axis = 0; axis < 3; ++axis) {
      const float of_a = in_a ? held(a, i, axis) : 0, of_b = in_b ? held(b, k, axis) : 0;
      changed += std::abs(of_a - of_b);
      all += of_a;
    }
    i += in_a;
    k += in_b;
  }
  return changed <= kSame * all;
}

}  // namespace fascia
