#include "sim/reference/static_residual.h"

#include <algorithm>

#include "sim/reference/elastic_system.h"

namespace fascia::reference {

double static_residual(const Model& model, const State& state) {
  const ElasticSystem system(model);
  const auto size = static_cast<Eigen::Index>(3 * state.displacement.size());
  Eigen::VectorXd u(size), weight(size), gradient;
  const std::vector<double> masses = lumped_masses(model);
  for (std::size_t v = 0; v < masses.size(); ++v) {
    u.segment<3>(static_cast<Eigen::Index>(3 * v)) = state.displacement[v];
    weight.segment<3>(static_cast<Eigen::Index>(3 * v)) = masses[v] * model.gravity;
  }
  system.evaluate(u, {}, gradient);
  const double scale = std::max(weight.norm(), gradient.norm());
  return scale > 0 ? system.free_part(gradient - weight).norm() / scale : 0;
}

}  // namespace fascia::reference
