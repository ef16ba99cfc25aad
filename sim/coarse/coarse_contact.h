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
#include <vector>

#include "sim/coarse/coarse_space.h"

namespace fascia {

/// The stiffness of contact at one material point, or between two: then the weights sum to 0.
struct PointStiffness {
  std::array<std::uint32_t, 4> vertices;
  std::array<double, 4> weights;
  Eigen::Matrix3d stiffness;  // [N/m]
};

struct CoarseContact {
  static constexpr std::size_t kMostNodes = 64;
  std::vector<std::uint32_t> nodes;  // that contact touches, ascending; the stiffest ones if there are more
  Eigen::MatrixXf stiffness;         // C [kg], [3 * nodes] square, in the rest frame of the coarse matrix
  bool operator==(const CoarseContact&) const = default;
};

/// `rotations` [node_count]: those of the nodes. `h` [s] is the length of the stage.
CoarseContact coarse_contact(const CoarseSpace& space, const std::vector<PointStiffness>& points,
                             const std::vector<Eigen::Quaternionf>& rotations, double h);

/// (I + C G)^-1 C. `inverse(i, k)`: entries of A^-1.
Eigen::MatrixXf push_back(const CoarseContact& contact,
                          const std::function<float(Eigen::Index, Eigen::Index)>& inverse);

/// Whether `b` may serve as `a`: the shares c g / (1 + c g) by which contact holds the coordinates of nodes, with the
/// diagonals c of C and g of A^-1, differ by a tenth of all at most. Much more or less of a stiff contact does nothing.
/// `compliance(i)`: g.
bool alike(const CoarseContact& a, const CoarseContact& b, const std::function<float(Eigen::Index)>& compliance);

}  // namespace fascia
