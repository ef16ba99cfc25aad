// The coarse problem of the two-level solver: the Hessian of an implicit Euler step at rest, seen from the coarse
// space, and its dense inverse. It depends on materials, h, masses and the held vertices only; rotations are applied
// around it.
#pragma once
#include <Eigen/Core>

#include "sim/coarse/coarse_space.h"

namespace fascia {

/// A_c = P^T (M + h^2 K) P [kg], with K the stiffness at rest, damping included. [3 * node_count] square, symmetric.
Eigen::MatrixXd coarse_matrix(const Model& model, const CoarseSpace& space, double h);

/// Of a symmetric positive semidefinite matrix, in single precision for the GPU. The diagonal is raised until it
/// factors: a function that the others can express adds nothing.
Eigen::MatrixXf coarse_inverse(Eigen::MatrixXd matrix);

struct VertexStiffness {
  std::uint32_t vertex;
  double stiffness;  // [N/m], the same in every direction
  bool operator==(const VertexStiffness&) const = default;
};

/// The inverse with h^2 times the stiffness of `springs` added to the matrix, by the formula of Sherman, Morrison and
/// Woodbury over what few functions the springs make: where a grab holds it, the body must not be as yielding as it is
/// free. The springs turn with the nodes, which changes nothing as far as those around a grab turn alike.
Eigen::MatrixXf with_stiffness(const Eigen::MatrixXf& inverse, const CoarseSpace& space,
                               const std::vector<VertexStiffness>& springs, double h);

}  // namespace fascia
