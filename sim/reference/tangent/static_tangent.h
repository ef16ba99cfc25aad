// How a static equilibrium follows a parameter of its scene, by implicit differentiation. An equilibrium balances the
// forces R(u, p) at the free vertices, and therefore
//
//   d u/d p = -K^-1 dR/dp,   K = dR/du
//
// with a factor of the Hessian at the equilibrium. dR/dp is a central difference of R at fixed u, which is a sum of
// closed forms: no equilibrium is solved again, and the quotient has eight digits. Materials, gravity, springs and the
// places of prescribed vertices may depend on p; the mesh may not. Without contact.
#pragma once
#include "sim/model/state.h"
#include "sim/reference/tangent/force_balance.h"

namespace fascia::reference {

class StaticTangent {
 public:
  explicit StaticTangent(const Model& model);

  /// Takes the equilibrium of `here` and factorizes there. False if it is not stable: the Hessian is not positive
  /// definite, and there are no rates.
  bool linearize(const State& equilibrium, const Nearby& here);
  /// d u/d p [vertex] [m per unit of p] from the scene at p - step and p + step. Precondition: linearize() was true.
  std::vector<Eigen::Vector3d> rate(const Nearby& below, const Nearby& above, double step);

 private:
  Eigen::VectorXd unbalanced(const Nearby& nearby, const Eigen::VectorXd& u);

  ForceBalance balance_;
  SparseMatrix hessian_;
  Cholesky cholesky_;
  Eigen::VectorXd u_;  // [3 * vertex_count] of the equilibrium
  double time_ = 0;    // [s]
};

}  // namespace fascia::reference
