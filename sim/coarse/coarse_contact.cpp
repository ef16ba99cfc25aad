#include "sim/coarse/coarse_contact.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace fascia {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3f;
using Eigen::MatrixXf;

/// The coarse functions at a point: nodes, ascending, and weights.
using Functions = std::vector<std::pair<std::uint32_t, double>>;

void add_functions(Functions& functions, const CoarseSpace& space, const PointStiffness& point) {
  const auto begin = static_cast<std::ptrdiff_t>(functions.size());
  for (std::size_t k = 0; k < 4; ++k)
    for (std::uint32_t e = space.begin[point.vertices[k]]; e < space.begin[point.vertices[k] + 1]; ++e) {
      if (point.weights[k] == 0) continue;
      const double weight = point.weights[k] * space.weight[e];
      const auto same = std::find_if(functions.begin() + begin, functions.end(),
                                     [&](const auto& function) { return function.first == space.node[e]; });
      if (same == functions.end())
        functions.emplace_back(space.node[e], weight);
      else
        same->second += weight;
    }
  std::sort(functions.begin() + begin, functions.end());
}

/// The nodes that feel most of the stiffness, ascending.
std::vector<std::uint32_t> stiffest_nodes(const std::vector<double>& trace) {
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < trace.size(); ++node)
    if (trace[node] > 0) nodes.push_back(node);
  if (nodes.size() <= CoarseContact::kMostNodes) return nodes;
  std::stable_sort(nodes.begin(), nodes.end(), [&](std::uint32_t a, std::uint32_t b) { return trace[a] > trace[b]; });
  nodes.resize(CoarseContact::kMostNodes);
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace

CoarseContact coarse_contact(const CoarseSpace& space, const std::vector<PointStiffness>& points,
                             const std::vector<Eigen::Quaternionf>& rotations, double h) {
  Functions functions;
  std::vector<std::size_t> end;  // of a point's functions
  std::vector<double> trace(space.node_count, 0);
  for (const PointStiffness& point : points) {
    const std::size_t begin = functions.size();
    add_functions(functions, space, point);
    end.push_back(functions.size());
    const double stiffness = point.stiffness.trace();
    for (std::size_t k = begin; k < functions.size(); ++k)
      trace[functions[k].first] += functions[k].second * functions[k].second * stiffness;
  }
  CoarseContact contact;
  contact.nodes = stiffest_nodes(trace);
  constexpr Index kNowhere = -1;
  std::vector<Index> place(space.node_count, kNowhere);
  for (std::size_t k = 0; k < contact.nodes.size(); ++k) place[contact.nodes[k]] = static_cast<Index>(k);

  // Blocks on and above the diagonal, first in the axes of the world
  const Index size = 3 * static_cast<Index>(contact.nodes.size());
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(size, size);
  std::size_t begin = 0;
  for (std::size_t p = 0; p < points.size(); begin = end[p++]) {
    const Matrix3d stiffness = h * h * points[p].stiffness;
    for (std::size_t k = begin; k < end[p]; ++k) {
      const Index column = place[functions[k].first];
      if (column == kNowhere) continue;
      const Matrix3d weighted = functions[k].second * stiffness;
      for (std::size_t i = begin; i <= k; ++i)
        if (const Index row = place[functions[i].first]; row != kNowhere)
          sums.block<3, 3>(3 * row, 3 * column) += functions[i].second * weighted;
    }
  }
  contact.stiffness.resize(size, size);
  std::vector<Matrix3f> axes;
  for (const std::uint32_t node : contact.nodes) axes.push_back(rotations[node].toRotationMatrix());
  for (Index k = 0; k < size / 3; ++k)
    for (Index i = 0; i <= k; ++i) {
      const Matrix3f block = axes[static_cast<std::size_t>(i)].transpose() *
                             sums.block<3, 3>(3 * i, 3 * k).cast<float>() * axes[static_cast<std::size_t>(k)];
      contact.stiffness.block<3, 3>(3 * i, 3 * k) = block;
      contact.stiffness.block<3, 3>(3 * k, 3 * i) = block.transpose();
    }
  return contact;
}

MatrixXf push_back(const CoarseContact& contact, const std::function<float(Index, Index)>& inverse) {
  const Index size = contact.stiffness.rows();
  MatrixXf compliance(size, size);
  for (Index i = 0; i < size; ++i)
    for (Index k = 0; k < size; ++k)
      compliance(i, k) = inverse(3 * contact.nodes[static_cast<std::size_t>(i / 3)] + i % 3,
                                 3 * contact.nodes[static_cast<std::size_t>(k / 3)] + k % 3);
  const MatrixXf both = MatrixXf::Identity(size, size) + contact.stiffness * compliance;
  return both.partialPivLu().solve(contact.stiffness);
}

bool alike(const CoarseContact& a, const CoarseContact& b, const std::function<float(Index)>& compliance) {
  constexpr float kSame = 0.1f;
  const auto held = [&](const CoarseContact& contact, std::size_t k, Index axis) {
    const float product = contact.stiffness.diagonal()[3 * static_cast<Index>(k) + axis] *
                          compliance(3 * static_cast<Index>(contact.nodes[k]) + axis);
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
