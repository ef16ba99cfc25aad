// The coarse problem of the two-level solver: the Hessian of an implicit Euler step at rest, seen from the coarse space, and its
// dense inverse. It depends on materials, h, masses and the held vertices only; rotations are applied around it.
#pragma once
#include <Eigen/Core>

#include "sim/coarse_space.h"

namespace fascia {

/// A_c = P^T (M + h^2 K) P [kg], with K the stiffness at rest, damping included. [3 * node_count] square, symmetric.
Eigen::MatrixXd coarse_matrix(const Model& model, const CoarseSpace& space, double h);

/// Of a symmetric positive semidefinite matrix, in single precision for the GPU. The diagonal is raised until it factors: a function
/// that the others can express adds nothing.
Eigen::MatrixXf coarse_inverse(Eigen::MatrixXd matrix);

}  // namespace fascia
