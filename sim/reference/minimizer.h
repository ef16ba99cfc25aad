// Newton's method with backtracking for the problem that a time step and a static equilibrium have in common:
//
//   minimize over the free u:  sum_e V_e Psi_e(u) + contact(u) + 1/2 (u - target)^T diag(inertia) (u - target)
//                              + 1/2 (u - predicted)^T coupled (u - predicted) - force . u
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <memory>
#include <stop_token>

#include "sim/contact/contact_energy.h"
#include "sim/reference/elastic_system.h"
#include "sim/reference/mass_matrix.h"
#include "sim/reference/newton.h"

namespace fascia::reference {

/// What moves at the centroids of quadratic tets (MassMatrix): `coupled` is its part of M / h^2.
struct CoupledInertia {
  const MassMatrix* mass = nullptr;
  double factor = 0;          // 1 / h^2 [1/s^2]
  Eigen::VectorXd predicted;  // u~ [3 * vertex_count], also of constrained vertices [m]

  bool acts() const { return mass && factor > 0 && !mass->is_diagonal(); }
  Eigen::VectorXd force(const Eigen::VectorXd& distance) const { return factor * mass->coupled_times(distance); }
};

/// Arrays are [3 * vertex_count]; entries of constrained vertices are not used.
struct Potential {
  ViscousStep viscous;
  Eigen::VectorXd inertia;  // m / h^2 of the vertices' own masses [N/m]; zero in statics
  Eigen::VectorXd target;   // u~ [m]
  Eigen::VectorXd start;    // u_n [m]; inertia * (u - start) is the force that would stop the motion
  Eigen::VectorXd force;    // [N]
  std::shared_ptr<const ContactEnergy> contact = nullptr;
  CoupledInertia coupled = {};
};

class Minimizer {
 public:
  explicit Minimizer(const ElasticSystem& system);

  /// Moves constrained vertices by `change` [3 * vertex_count] and the free ones by one linear step, unless leaving the
  /// free ones in place has less energy or inverts no tet.
  void move_held(const Potential& potential, const Eigen::VectorXd& change, Eigen::VectorXd& u);

  struct Limits {
    int iterations;
    bool upright;  // give up as soon as a tet inverts
    std::stop_token stop;
  };
  /// Whether the minimum `to` is above `from`, by more than rounding: Newton's method then went from where the velocity
  /// leads to the minimum of another motion, such as a stiff body on another of its faces.
  bool climbs(const Potential& potential, const Eigen::VectorXd& from, const Eigen::VectorXd& to) const;
  /// Minimizes from `u` with its constrained entries kept, to |gradient| <= tolerance * force scale (NewtonReport) or
  /// to the rounding of the gradient, whichever is larger.
  NewtonReport minimize(const Potential& potential, double tolerance, const Limits& limits, Eigen::VectorXd& u);

 private:
  struct Value {
    double energy = 0;         // [J]
    double magnitude = 0;      // [J] sum of absolute terms, for a bound on the rounding of `energy`
    Eigen::VectorXd gradient;  // [N] over the unknowns
    double force_scale = 0;    // [N] NewtonReport
  };
  Value evaluate(const Potential& potential, const Eigen::VectorXd& u) const;
  NewtonReport descend(const Potential& potential, double tolerance, const Limits& limits, Eigen::VectorXd& u);
  void factorize(const Potential& potential, const Eigen::VectorXd& u);
  /// Whether the factor is that of the same problem, at a place where it was solved before.
  bool has_factor_of(const Potential& potential) const;
  void add_contact(const ContactEnergy& contact, const Eigen::VectorXd& u, bool project, Eigen::VectorXd& scale);
  void couple(const PairEnergy& pairs, const Eigen::VectorXd& u, Eigen::VectorXd& scale);
  bool factorize_sum(double shift = 0);
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  bool line_search(const Potential& potential, const Eigen::VectorXd& direction, Eigen::VectorXd& u, Value& value,
                   double& step) const;

  const ElasticSystem& system_;
  SparseMatrix hessian_;
  Cholesky cholesky_;
  /// Of the sum with tissue that touches tissue, whose blocks change their places from step to step; else null.
  using CoupledCholesky = Eigen::SimplicialLLT<SparseMatrix, Eigen::Upper>;
  std::unique_ptr<CoupledCholesky> coupled_;
  SparseMatrix coupled_hessian_;
  struct Factored {
    Eigen::VectorXd inertia;
    double coupled = 0;  // CoupledInertia::factor
    double length = 0;   // [s] ViscousStep::h
  };
  Factored factored_;    // what the factor is of, without contact and unprojected; else empty
  double rounding_ = 0;  // [N] bound on the rounding of the gradient at the last factorization
};

}  // namespace fascia::reference
