// How the motion of a scene follows a parameter, by implicit differentiation of every stage of its steps. A stage ends
// where the forces R(u, s, p) at the free vertices vanish, with the state s at its start, and therefore
//
//   d u/d p = -K^-1 (dR/ds ds/dp + dR/dp),   K = dR/du
//
// with a factor of the Hessian at the end of the stage. The bracket is a central difference of R at fixed free u along
// (ds/dp, 1), which is a sum of closed forms: no stage is solved again (static_tangent.h). Without contact.
#pragma once
#include "sim/integrators/stage.h"
#include "sim/model/state.h"
#include "sim/reference/tangent/force_balance.h"

namespace fascia::reference {

/// d/d p of a State [3 * vertex_count].
struct StateRate {
  Eigen::VectorXd displacement, velocity;                  // [m], [m/s] per unit of p
  Eigen::VectorXd earlier_displacement, earlier_velocity;  // of State::earlier; empty where that is
  Eigen::VectorXd acceleration = {};                       // [m/s^2] per unit of p; empty before the first stage
};

class StepTangent {
 public:
  explicit StepTangent(const Model& model);

  /// Takes a stage of `here` from the state `before` to the displacements `after` [vertex] and factorizes there. False
  /// if the Hessian is not positive definite.
  bool linearize(const IntegratorStage& stage, const State& before, const std::vector<Eigen::Vector3d>& after,
                 const Nearby& here);
  /// The rate at the end of the stage from that at its start and the scene at p - step and p + step. Precondition:
  /// linearize() was true.
  StateRate rate(const StateRate& start, const Nearby& below, const Nearby& above, double step);

  StateRate at_rest() const;  // zero

 private:
  struct Start {
    Eigen::VectorXd displacement, velocity, earlier_displacement, earlier_velocity;
  };
  Start moved(const StateRate& rate, double step) const;
  ViscousStep viscous_from(const Start& start) const;
  Eigen::VectorXd unbalanced(const Nearby& nearby, const Start& start, const Eigen::VectorXd& u);

  ForceBalance balance_;
  SparseMatrix hessian_;
  Cholesky cholesky_;
  IntegratorStage stage_{1};
  Start before_;
  Eigen::VectorXd after_;  // [3 * vertex_count]
  double end_ = 0;         // [s]
};

}  // namespace fascia::reference
