#include "sim/coarse/coarse_contact.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace fascia {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3f;
using Eigen::MatrixXf;

// The inverse of a symmetric positive definite matrix, or nothing. By columns of the inverse factor from their first
// entries on, some at a time.
MatrixXf inverse_of(const MatrixXf& matrix) {
  constexpr Index kColumns = 48;
  const Index size = matrix.rows();
  const Eigen::LLT<MatrixXf> factor(matrix);
  if (factor.info() != Eigen::Success) return {};
  MatrixXf lower = MatrixXf::Identity(size, size), inverse = MatrixXf::Zero(size, size);
  for (Index k = 0; k < size; k += kColumns) {
    const Index rest = size - k, count = std::min(kColumns, rest);
    auto columns = lower.block(k, k, rest, count);
    factor.matrixLLT().bottomRightCorner(rest, rest).triangularView<Eigen::Lower>().solveInPlace(columns);
  }
  for (Index k = 0; k < size; k += kColumns) {
    const Index count = std::min(kColumns, size - k), end = k + count;
    inverse.topLeftCorner(end, end).selfadjointView<Eigen::Lower>().rankUpdate(
        lower.block(k, 0, count, end).transpose());
  }
  inverse.triangularView<Eigen::StrictlyUpper>() = inverse.transpose();
  return inverse;
}

// Whether the stiffness that a compliance leaves of another is between nothing and that, as far as its diagonal says.
bool is_part_of(const MatrixXf& left, const MatrixXf& stiffness) {
  constexpr float kRounding = 1e-2f;
  for (Index i = 0; i < left.rows(); ++i)
    if (!(left(i, i) >= -kRounding * stiffness(i, i) && left(i, i) <= (1 + kRounding) * stiffness(i, i))) return false;
  return true;
}

// L (1 + L^T G L)^-1 L^T with C = L L^T, which is between nothing and C whatever the conditions of both. Roundings may
// make G indefinite, which a growing multiple of the identity hides.
MatrixXf push_back_slowly(const MatrixXf& stiffness, const MatrixXf& compliance) {
  using Eigen::MatrixXd;
  const Eigen::LDLT<MatrixXd> factor(stiffness.cast<double>());
  const MatrixXd lower = factor.matrixL();
  const MatrixXd root =
      factor.transpositionsP().transpose() * MatrixXd(lower * factor.vectorD().cwiseMax(0).cwiseSqrt().asDiagonal());
  MatrixXd sum = root.transpose() * compliance.cast<double>() * root;
  const double largest = sum.diagonal().maxCoeff();
  sum.diagonal().array() += 1;
  for (double shift = 1e-7 * largest;; shift *= 10) {
    const Eigen::LLT<MatrixXd> inner(sum);
    if (inner.info() != Eigen::Success && std::isfinite(shift)) {
      sum.diagonal().array() += shift;
      continue;
    }
    MatrixXd part = root.transpose();
    inner.matrixL().solveInPlace(part);
    return (part.transpose() * part).cast<float>();
  }
}

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

std::span<const PointFunctions::Function> PointFunctions::at(const CoarseSpace& space, const PointStiffness& point) {
  const bool keep = point.number != PointStiffness::kUnnumbered;
  if (keep && point.number < parts_.size() && parts_[point.number].count > 0)
    return std::span(kept_).subspan(parts_[point.number].begin, parts_[point.number].count);
  last_.clear();
  for (std::size_t k = 0; k < 4; ++k) {
    if (point.weights[k] == 0) continue;
    for (std::uint32_t e = space.begin[point.vertices[k]]; e < space.begin[point.vertices[k] + 1]; ++e) {
      const double weight = point.weights[k] * space.weight[e];
      const auto same = std::find_if(last_.begin(), last_.end(),
                                     [&](const Function& function) { return function.first == space.node[e]; });
      if (same == last_.end())
        last_.emplace_back(space.node[e], weight);
      else
        same->second += weight;
    }
  }
  std::sort(last_.begin(), last_.end());
  if (!keep) return last_;
  if (point.number >= parts_.size()) parts_.resize(point.number + std::size_t{1});
  parts_[point.number] = {kept_.size(), last_.size()};
  kept_.insert(kept_.end(), last_.begin(), last_.end());
  return std::span(kept_).last(last_.size());
}

TouchedNodes touched_nodes(const CoarseSpace& space, PointFunctions& functions,
                           const std::vector<PointStiffness>& points, const std::vector<Eigen::Quaternionf>& rotations,
                           double h) {
  std::vector<Matrix3d> blocks(space.node_count, Matrix3d::Zero());
  for (const PointStiffness& point : points)
    for (const auto& [node, weight] : functions.at(space, point)) blocks[node] += weight * weight * point.stiffness;
  TouchedNodes touched{stiffest_nodes(blocks), {}};
  touched.stiffness.resize(3 * static_cast<Index>(touched.nodes.size()));
  for (Index k = 0; k < touched.stiffness.size() / 3; ++k) {
    const std::uint32_t node = touched.nodes[static_cast<std::size_t>(k)];
    const Matrix3d axes = rotations[node].toRotationMatrix().cast<double>();
    touched.stiffness.segment<3>(3 * k) = (h * h * (axes.transpose() * blocks[node] * axes).diagonal()).cast<float>();
  }
  return touched;
}

MatrixXf stiffness_between(const std::vector<std::uint32_t>& nodes, const CoarseSpace& space, PointFunctions& functions,
                           const std::vector<PointStiffness>& points, const std::vector<Eigen::Quaternionf>& rotations,
                           double h) {
  constexpr Index kNowhere = -1;
  std::vector<Index> place(space.node_count, kNowhere);
  for (std::size_t k = 0; k < nodes.size(); ++k) place[nodes[k]] = static_cast<Index>(k);

  // Blocks on and above the diagonal, first in the axes of the world
  const Index size = 3 * static_cast<Index>(nodes.size());
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(size, size);
  for (const PointStiffness& point : points) {
    const Matrix3d at_point = h * h * point.stiffness;
    const std::span<const PointFunctions::Function> at = functions.at(space, point);
    for (const auto& [right, weight] : at) {
      const Index column = place[right];
      if (column == kNowhere) continue;
      const Matrix3d weighted = weight * at_point;
      for (const auto& [left, other] : at) {
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

NodeCompliance compliance_of(const std::vector<std::uint32_t>& nodes,
                             const std::function<float(Index, Index)>& inverse) {
  const Index size = 3 * static_cast<Index>(nodes.size());
  NodeCompliance result{nodes, MatrixXf(size, size), {}};
  for (Index k = 0; k < size; ++k)
    for (Index i = 0; i < size; ++i)
      result.matrix(i, k) = inverse(3 * nodes[static_cast<std::size_t>(i / 3)] + i % 3,
                                    3 * nodes[static_cast<std::size_t>(k / 3)] + k % 3);
  result.inverse = inverse_of(result.matrix);
  return result;
}

MatrixXf push_back(const MatrixXf& stiffness, const NodeCompliance& compliance) {
  const Index size = stiffness.rows();
  if (compliance.inverse.rows() == size) {
    MatrixXf sum = compliance.inverse + stiffness;
    const Eigen::LLT<Eigen::Ref<MatrixXf>> factor(sum);
    if (factor.info() == Eigen::Success) {
      MatrixXf part = compliance.inverse, result = compliance.inverse;
      factor.matrixL().solveInPlace(part);
      result.selfadjointView<Eigen::Lower>().rankUpdate(part.transpose(), -1);
      if (is_part_of(result, stiffness)) {
        result.triangularView<Eigen::StrictlyUpper>() = result.transpose();
        return result;
      }
    }
  }
  return push_back_slowly(stiffness, compliance.matrix);
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
