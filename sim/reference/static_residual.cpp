#include "sim/reference/static_residual.h"

#include <algorithm>

namespace fascia::reference {

StaticResidual::StaticResidual(const Model& model)
    : system_(model), weight_(static_cast<Eigen::Index>(3 * model.rest_positions.size())) {
  const std::vector<double> masses = consistent_masses(model);
  for (std::size_t v = 0; v < masses.size(); ++v)
    weight_.segment<3>(static_cast<Eigen::Index>(3 * v)) = masses[v] * model.gravity;
}

double StaticResidual::operator()(const State& state, const std::vector<GrabSpring>& springs,
                                  const std::vector<Eigen::Vector3d>& contact) const {
  Eigen::VectorXd u(weight_.size()), load = weight_, gradient;
  for (std::size_t v = 0; v < state.displacement.size(); ++v)
    u.segment<3>(static_cast<Eigen::Index>(3 * v)) = state.displacement[v];
  for (const GrabSpring& spring : springs)
    load.segment<3>(static_cast<Eigen::Index>(3 * spring.vertex)) +=
        spring.stiffness * (spring.target - state.displacement[spring.vertex]);
  system_.evaluate(u, {}, gradient);
  const double scale = std::max(load.norm(), gradient.norm());
  for (std::size_t v = 0; v < contact.size(); ++v) load.segment<3>(static_cast<Eigen::Index>(3 * v)) += contact[v];
  return scale > 0 ? system_.free_part(gradient - load).norm() / scale : 0;
}

}  // namespace fascia::reference
