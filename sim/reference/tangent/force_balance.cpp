#include "sim/reference/tangent/force_balance.h"

namespace fascia::reference {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

ForceBalance::ForceBalance(const Model& model) : model_(model), system_(model_) {}

VectorXd ForceBalance::placed(const VectorXd& u, const Model& nearby, double time) const {
  VectorXd result = u;
  for (const Motion& motion : nearby.motions)
    for (std::size_t k = 0; k < motion.vertices.size(); ++k) {
      const Vector3d& rest = model_.rest_positions[motion.vertices[k]];
      result.segment<3>(static_cast<Index>(3 * motion.vertices[k])) = motion.position(k, rest, time) - rest;
    }
  return result;
}

VectorXd ForceBalance::inner_forces(const Nearby& nearby, const VectorXd& u, const ViscousStep& viscous) {
  set_materials(nearby.model);
  VectorXd forces;
  system_.evaluate(u, viscous, forces);
  for (const GrabSpring& spring : nearby.springs) {
    const auto i = static_cast<Index>(3 * spring.vertex);
    forces.segment<3>(i) += spring.stiffness * (u.segment<3>(i) - spring.target);
  }
  return forces;
}

MassMatrix ForceBalance::masses(const Model& nearby) {
  set_materials(nearby);
  return MassMatrix(model_);
}

VectorXd ForceBalance::weight(const Model& nearby) {
  set_materials(nearby);
  VectorXd all(static_cast<Index>(3 * model_.rest_positions.size()));
  const std::vector<double> masses = consistent_masses(model_);
  for (std::size_t v = 0; v < masses.size(); ++v)
    all.segment<3>(static_cast<Index>(3 * v)) = masses[v] * nearby.gravity;
  return all;
}

VectorXd ForceBalance::gravity(const Model& nearby) const {
  return nearby.gravity.replicate(static_cast<Index>(model_.rest_positions.size()), 1);
}

VectorXd ForceBalance::stiffness(const std::vector<GrabSpring>& springs) const {
  VectorXd all = VectorXd::Zero(static_cast<Index>(3 * model_.rest_positions.size()));
  for (const GrabSpring& spring : springs)
    all.segment<3>(static_cast<Index>(3 * spring.vertex)).array() += spring.stiffness;
  return all;
}

}  // namespace fascia::reference
