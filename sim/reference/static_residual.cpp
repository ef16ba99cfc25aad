#include "sim/reference/static_residual.h"

#include <algorithm>

#include "sim/reference/elastic_system.h"

namespace fascia::reference {

double static_residual(const Model& model, const State& state, const std::vector<GrabSpring>& springs) {
  const ElasticSystem system(model);
  const auto size = static_cast<Eigen::Index>(3 * state.displacement.size());
  Eigen::VectorXd u(size), load(size), gradient;
  const std::vector<double> masses = lumped_masses(model);
  for (std::size_t v = 0; v < masses.size(); ++v) {
    u.segment<3>(static_cast<Eigen::Index>(3 * v)) = state.displacement[v];
    load.segment<3>(static_cast<Eigen::Index>(3 * v)) = masses[v] * model.gravity;
  }
  for (const GrabSpring& spring : springs)
    load.segment<3>(static_cast<Eigen::Index>(3 * spring.vertex)) += spring.stiffness * (spring.target - state.displacement[spring.vertex]);
  system.evaluate(u, {}, gradient);
  const double scale = std::max(load.norm(), gradient.norm());
  return scale > 0 ? system.free_part(gradient - load).norm() / scale : 0;
}

}  // namespace fascia::reference
