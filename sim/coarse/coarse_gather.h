// What a coarse node gathers from vertices: their forces, and how the tissue around it has turned.
#pragma once
#include "sim/coarse/coarse_space.h"

namespace fascia {

/// P^T in rows of nodes: entries begin[j] to begin[j + 1].
struct CoarseTranspose {
  std::vector<std::uint32_t> begin;  // [node_count + 1]
  std::vector<std::uint32_t> vertex;
  std::vector<double> weight;
};
CoarseTranspose transpose(const CoarseSpace& space);

/// The mean deformation gradient around every coarse node as a weighted sum of displacements, M_j = I + sum_a u_a
/// c_ja^T, which holds because F is linear in u. A tet counts by its volume, stiffness and the node's weight in it:
/// beside stiff tissue soft tets may turn any way. Those whose stiffness times weight is below half the node's largest
/// are left out, which saves most of the entries and turns stiff bodies no worse. Entries begin[j] to begin[j + 1].
struct CoarseGather {
  std::vector<std::uint32_t> begin;  // [node_count + 1]
  std::vector<std::uint32_t> vertex;
  std::vector<Eigen::Vector3d> gradient;  // c_ja [1/m]
};
CoarseGather make_coarse_gather(const Model& model, const CoarseSpace& space);

}  // namespace fascia
