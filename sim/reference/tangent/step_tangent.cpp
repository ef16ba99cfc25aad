#include "sim/reference/tangent/step_tangent.h"

namespace fascia::reference {

using Eigen::VectorXd;

StepTangent::StepTangent(const Model& model)
    : balance_(model),
      hessian_(balance_.system().empty_hessian()),
      cholesky_(hessian_, balance_.system().elimination_tree()) {}

StateRate StepTangent::at_rest() const {
  const VectorXd zero = VectorXd::Zero(static_cast<Eigen::Index>(3 * balance_.system().first_dof().size()));
  return {zero, zero, {}, {}};
}

bool StepTangent::linearize(const IntegratorStage& stage, const State& before,
                            const std::vector<Eigen::Vector3d>& after, const Nearby& here) {
  stage_ = stage;
  before_ = {flattened(before.displacement), flattened(before.velocity), flattened(before.earlier.displacement),
             flattened(before.earlier.velocity)};
  after_ = flattened(after);
  end_ = before.time + stage.duration;
  const MassMatrix masses = balance_.masses(here.model);
  VectorXd scale;
  balance_.system().assemble(after_, viscous_from(before_), false, hessian_, scale);
  hessian_.diagonal() += balance_.system().free_part(stage.inertia(masses.own()) + balance_.stiffness(here.springs));
  masses.add_coupled(1 / (stage.length * stage.length), balance_.system(), hessian_);
  return cholesky_.factorize(hessian_);
}

StepTangent::Start StepTangent::moved(const StateRate& rate, double step) const {
  Start start = before_;
  start.displacement += step * rate.displacement;
  start.velocity += step * rate.velocity;
  if (stage_.extrapolation == 0) return start;
  start.earlier_displacement += step * rate.earlier_displacement;
  start.earlier_velocity += step * rate.earlier_velocity;
  return start;
}

ViscousStep StepTangent::viscous_from(const Start& start) const {
  const ElasticSystem& system = balance_.system();
  if (!system.viscous()) return {};
  ViscousStep viscous{system.strains(start.displacement), stage_.length};
  if (stage_.extrapolation == 0) return viscous;
  const std::vector<Eigen::Matrix3d> earlier = system.strains(start.earlier_displacement);
  for (std::size_t i = 0; i < earlier.size(); ++i)
    viscous.previous_strain[i] = stage_.extrapolated(viscous.previous_strain[i], earlier[i]);
  return viscous;
}

VectorXd StepTangent::unbalanced(const Nearby& nearby, const Start& start, const VectorXd& u) {
  const MassMatrix masses = balance_.masses(nearby.model);
  const VectorXd target =
      stage_.predicted(stage_.extrapolated(start.displacement, start.earlier_displacement),
                       stage_.extrapolated(start.velocity, start.earlier_velocity), balance_.gravity(nearby.model));
  return balance_.system().free_part(balance_.inner_forces(nearby, u, viscous_from(start)) +
                                     stage_.inertia(masses.times(u - target)));
}

StateRate StepTangent::rate(const StateRate& start, const Nearby& below, const Nearby& above, double step) {
  const VectorXd down = balance_.placed(after_, below.model, end_), up = balance_.placed(after_, above.model, end_);
  StateRate end{(up - down) / (2 * step), {}, start.displacement, start.velocity};
  const VectorXd change =
      (unbalanced(above, moved(start, step), up) - unbalanced(below, moved(start, -step), down)) / (2 * step);
  balance_.system().add_to_free(cholesky_.solve(change), -1, end.displacement);
  end.velocity = stage_.velocity(end.displacement, stage_.extrapolated(start.displacement, start.earlier_displacement));
  end.acceleration = stage_.acceleration(end.velocity, stage_.extrapolated(start.velocity, start.earlier_velocity));
  return end;
}

}  // namespace fascia::reference
