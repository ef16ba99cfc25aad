// The stiffness of contact in the coarse problem of the two-level solver. The coarse matrix is made once, without
// contact; what touches changes in every step, and its stiffness is added to the inverse by the
// Sherman-Morrison-Woodbury formula, over the coarse nodes that it touches:
//
//   (A + W C W^T)^-1 r = x - A^-1 W (I + C G)^-1 C W^T x   with x = A^-1 r and G = W^T A^-1 W
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "sim/coarse/coarse_space.h"

namespace fascia {

/// The stiffness of contact at one material point, or between two: then the weights sum to 0.
struct PointStiffness {
  static constexpr std::uint32_t kUnnumbered = 0xffffffff;
  std::array<std::uint32_t, 4> vertices;
  std::array<double, 4> weights;
  Eigen::Matrix3d stiffness;           // [N/m]
  std::uint32_t number = kUnnumbered;  // of a point whose vertices and weights are always the same
};

/// The coarse functions at points. Keeps those of numbered points.
class PointFunctions {
 public:
  using Function = std::pair<std::uint32_t, double>;  // node, weight
  /// Ascending by nodes. Valid until the next call.
  std::span<const Function> at(const CoarseSpace& space, const PointStiffness& point);

 private:
  struct Part {
    std::size_t begin = 0, count = 0;  // count 0: not yet known
  };
  std::vector<Function> kept_, last_;
  std::vector<Part> parts_;  // [number] of kept_
};

/// The coarse nodes that contact touches, and how stiffly it holds each.
struct TouchedNodes {
  static constexpr std::size_t kMost = 64;
  std::vector<std::uint32_t> nodes;  // ascending; the stiffest ones if there are more than kMost
  Eigen::VectorXf stiffness;         // [3 * nodes] the diagonal of C [kg], in the rest frame of the coarse matrix
};

/// `rotations` [node_count]: those of the nodes. `h` [s] is the length of the stage.
TouchedNodes touched_nodes(const CoarseSpace& space, PointFunctions& functions,
                           const std::vector<PointStiffness>& points, const std::vector<Eigen::Quaternionf>& rotations,
                           double h);

/// C [kg], [3 * nodes] square, for the nodes that `touched_nodes` returns for the same arguments.
Eigen::MatrixXf stiffness_between(const std::vector<std::uint32_t>& nodes, const CoarseSpace& space,
                                  PointFunctions& functions, const std::vector<PointStiffness>& points,
                                  const std::vector<Eigen::Quaternionf>& rotations, double h);

/// G, which stays while A^-1 and the nodes do.
struct NodeCompliance {
  std::vector<std::uint32_t> nodes;
  Eigen::MatrixXf matrix;   // G [1/kg], [3 * nodes] square
  Eigen::MatrixXf inverse;  // empty if rounding leaves G indefinite
};

/// `inverse(i, k)`: entries of A^-1.
NodeCompliance compliance_of(const std::vector<std::uint32_t>& nodes,
                             const std::function<float(Eigen::Index, Eigen::Index)>& inverse);

/// (I + C G)^-1 C [kg], as K - K (K + C)^-1 K with K = G^-1 if there is one: symmetric factors take half of the time.
Eigen::MatrixXf push_back(const Eigen::MatrixXf& stiffness, const NodeCompliance& compliance);

/// Whether the stiffness of `b` may serve for `a`: the shares c g / (1 + c g) by which contact holds the coordinates of
/// nodes, with the diagonals c of C and g of A^-1, differ by a tenth of all at most. Much more or less of a stiff
/// contact does nothing. `compliance(i)`: g.
bool alike(const TouchedNodes& a, const TouchedNodes& b, const std::function<float(Eigen::Index)>& compliance);

}  // namespace fascia
