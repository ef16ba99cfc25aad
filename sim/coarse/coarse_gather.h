// Sums over vertices at a coarse node: their forces, and the mean deformation of the tissue around the node.
#pragma once
#include "sim/coarse/coarse_space.h"

namespace fascia {

/// P^T by rows of nodes: entries begin[j] to begin[j + 1].
struct CoarseTranspose {
  std::vector<std::uint32_t> begin;  // [node_count + 1]
  std::vector<std::uint32_t> vertex;
  std::vector<double> weight;
};
CoarseTranspose transpose(const CoarseSpace& space);

/// The mean deformation gradient around every coarse node as a weighted sum of displacements, M_j = I + sum_a u_a
/// c_ja^T. The sum is exact because F is linear in u. A tet has the weight volume * stiffness * the node's weight in
/// it, since soft tets beside stiff tissue may rotate arbitrarily. Tets whose stiffness * weight is below half the
/// node's largest are left out: this saves most of the entries and gives stiff bodies the same rotation. Entries
/// begin[j] to begin[j + 1].
struct CoarseGather {
  std::vector<std::uint32_t> begin;  // [node_count + 1]
  std::vector<std::uint32_t> vertex;
  std::vector<Eigen::Vector3d> gradient;  // c_ja [1/m]
};
CoarseGather make_coarse_gather(const Model& model, const CoarseSpace& space);

}  // namespace fascia
