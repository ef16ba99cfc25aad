// The path of a Model's constrained vertices during a step or a load increment, and a check that every component is
// supported.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "sim/model/model.h"

namespace fascia::reference {

/// Leads from the constrained positions of a state at time `from` to those of the motions at time `to` [s]. Between the
/// ends it samples the motions, with jumps spread over the whole interval, so that a rotation stays a rotation; the
/// initial difference between state and motions fades out.
class HeldPath {
 public:
  HeldPath(const Model& model, const Eigen::VectorXd& displacement, double from, double to);
  /// Moves the constrained entries of `u` [3 * vertex_count] to the share s in [0, 1] of the path.
  void place(double s, Eigen::VectorXd& u) const;
  bool moves() const;
  /// Largest increment of s in which no motion rotates too far for a linear prediction.
  double largest_increment() const;

 private:
  Eigen::VectorXd positions(double t) const;  // displacements, zero where no motion acts

  const Model& model_;
  double from_, to_;
  std::vector<Motion> motions_;
  Eigen::VectorXd offset_;
};

/// Throws Error if gravity acts on an unconstrained component: it has no static equilibrium.
void require_supports(const Model& model);

}  // namespace fascia::reference
