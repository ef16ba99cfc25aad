#include "sim/coarse/coarse_contact.h"

#include <Eigen/LU>
#include <algorithm>
#include <map>

namespace fascia {
namespace {

using Eigen::Index;
using Eigen::Matrix3f;
using Eigen::MatrixXf;

// The coarse functions at a point: nodes and weights.
std::vector<std::pair<std::uint32_t, float>> functions_at(const CoarseSpace& space, const PointStiffness& point) {
  std::map<std::uint32_t, double> weights;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::uint32_t e = space.begin[point.vertices[k]]; e < space.begin[point.vertices[k] + 1]; ++e)
      if (point.weights[k] != 0) weights[space.node[e]] += point.weights[k] * space.weight[e];
  return {weights.begin(), weights.end()};
}

}  // namespace

CoarseContact coarse_contact(const CoarseSpace& space, const std::vector<PointStiffness>& points,
                             const std::vector<Eigen::Quaternionf>& rotations, double h) {
  std::vector<std::vector<std::pair<std::uint32_t, float>>> functions;
  std::map<std::uint32_t, double> trace;
  for (const PointStiffness& point : points) {
    functions.push_back(functions_at(space, point));
    for (const auto& [node, weight] : functions.back()) trace[node] += weight * weight * point.stiffness.trace();
  }
  CoarseContact contact;
  std::vector<std::pair<double, std::uint32_t>> stiffest;
  for (const auto& [node, sum] : trace) stiffest.emplace_back(-sum, node);
  std::sort(stiffest.begin(), stiffest.end());
  stiffest.resize(std::min(stiffest.size(), CoarseContact::kMostNodes));
  for (const auto& [sum, node] : stiffest) contact.nodes.push_back(node);
  std::sort(contact.nodes.begin(), contact.nodes.end());
  std::map<std::uint32_t, Index> place;
  std::vector<Matrix3f> axes;
  for (const std::uint32_t node : contact.nodes) {
    place[node] = static_cast<Index>(axes.size());
    axes.push_back(rotations[node].toRotationMatrix());
  }
  const Index size = 3 * static_cast<Index>(contact.nodes.size());
  contact.stiffness = MatrixXf::Zero(size, size);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Matrix3f stiffness = (h * h * points[p].stiffness).cast<float>();
    for (const auto& [a, weight_a] : functions[p]) {
      const auto i = place.find(a);
      if (i == place.end()) continue;
      const Matrix3f row = weight_a * axes[static_cast<std::size_t>(i->second)].transpose() * stiffness;
      for (const auto& [b, weight_b] : functions[p])
        if (const auto k = place.find(b); k != place.end())
          contact.stiffness.block<3, 3>(3 * i->second, 3 * k->second) +=
              weight_b * row * axes[static_cast<std::size_t>(k->second)];
    }
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

bool alike(const CoarseContact& a, const CoarseContact& b) {
  return a.nodes == b.nodes && (a.stiffness - b.stiffness).norm() <= 0.1f * a.stiffness.norm();
}

}  // namespace fascia
