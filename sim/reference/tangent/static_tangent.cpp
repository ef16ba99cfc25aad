#include "sim/reference/tangent/static_tangent.h"

namespace fascia::reference {

using Eigen::Vector3d;
using Eigen::VectorXd;

StaticTangent::StaticTangent(const Model& model)
    : balance_(model),
      hessian_(balance_.system().empty_hessian()),
      cholesky_(hessian_, balance_.system().elimination_tree()) {}

bool StaticTangent::linearize(const State& equilibrium, const Nearby& here) {
  time_ = equilibrium.time;
  u_ = flattened(equilibrium.displacement);
  balance_.set_materials(here.model);
  VectorXd scale;
  balance_.system().assemble(u_, {}, false, hessian_, scale);
  hessian_.diagonal() += balance_.system().free_part(balance_.stiffness(here.springs));
  return cholesky_.factorize(hessian_);
}

VectorXd StaticTangent::unbalanced(const Nearby& nearby, const VectorXd& u) {
  const VectorXd weight = balance_.weight(nearby.model);
  return balance_.system().free_part(balance_.inner_forces(nearby, u, {}) - weight);
}

std::vector<Vector3d> StaticTangent::rate(const Nearby& below, const Nearby& above, double step) {
  const VectorXd down = balance_.placed(u_, below.model, time_), up = balance_.placed(u_, above.model, time_);
  VectorXd rate = (up - down) / (2 * step);
  const VectorXd change = (unbalanced(above, up) - unbalanced(below, down)) / (2 * step);
  balance_.system().add_to_free(cholesky_.solve(change), -1, rate);
  return as_vectors(rate);
}

}  // namespace fascia::reference
