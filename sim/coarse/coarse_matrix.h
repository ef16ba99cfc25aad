// The coarse problem of the two-level solver: the Hessian of an implicit Euler step at rest, projected onto the coarse
// space, and its dense inverse. It depends on materials, h, masses and the constrained vertices only; rotations are
// applied around the matrix.
#pragma once
#include <Eigen/Core>

#include "sim/coarse/coarse_space.h"

namespace fascia {

/// A_c = P^T (M + h^2 K) P [kg], with K the stiffness at rest including damping. [3 * node_count] square, symmetric.
Eigen::MatrixXd coarse_matrix(const Model& model, const CoarseSpace& space, double h);

/// The inverse of a symmetric positive semidefinite matrix, in single precision for the GPU. The diagonal is raised
/// until the factorization succeeds: a function that depends linearly on the others then adds nothing.
Eigen::MatrixXf coarse_inverse(Eigen::MatrixXd matrix);

struct VertexStiffness {
  std::uint32_t vertex;
  double stiffness;  // [N/m], the same in every direction
  bool operator==(const VertexStiffness&) const = default;
};

/// The inverse with h^2 times the stiffness of `springs` added to the matrix, by the Sherman-Morrison-Woodbury formula
/// over the few functions that have springs. A grabbed region must not be as compliant as a free one. The springs
/// rotate with the nodes, which has no effect while the nodes around a grab rotate alike.
Eigen::MatrixXf with_stiffness(const Eigen::MatrixXf& inverse, const CoarseSpace& space,
                               const std::vector<VertexStiffness>& springs, double h);

}  // namespace fascia
