// The projection goes by the mass matrix of the kinetic energy. Masses of vertices alone, lumped ones or row sums, do
// not give quadratic tets both their momentum and their angular momentum, since half of their mass moves with the
// velocity at the centroid. Shape functions have rigid fields exactly, so that the products below are those integrals.
#include "app/bench/fill/rigid_motion.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "sim/reference/mass_matrix.h"

namespace fascia {

using Eigen::Index;
using Eigen::Vector3d;

void remove_rigid_motion(Model& model) {
  const auto count = static_cast<Index>(model.rest_positions.size());
  Eigen::Matrix<double, Eigen::Dynamic, 6> rigid(3 * count, 6), impulses(3 * count, 6);
  for (Index v = 0; v < count; ++v)
    for (int axis = 0; axis < 3; ++axis) {
      rigid.block<3, 1>(3 * v, axis) = Vector3d::Unit(axis);
      rigid.block<3, 1>(3 * v, 3 + axis) =
          Vector3d::Unit(axis).cross(model.rest_positions[static_cast<std::size_t>(v)]);
    }
  const reference::MassMatrix mass(model);
  for (int mode = 0; mode < 6; ++mode) impulses.col(mode) = mass.times(rigid.col(mode));
  Eigen::Map<Eigen::VectorXd> velocity(model.initial_velocity.front().data(), 3 * count);
  const Eigen::Matrix<double, 6, 1> share =
      (impulses.transpose() * rigid).ldlt().solve(impulses.transpose() * velocity);
  velocity -= rigid * share;
}

}  // namespace fascia
