// Where the held vertices of a Model go during a step or a load increment, and which bodies lack any.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "sim/model/model.h"

namespace fascia::reference {

/// From where a state holds its vertices at time `from` to where the motions put them at time `to` [s].
/// Between the ends it samples the motions, with jumps spread over the whole interval, so that a turn stays a
/// turn; what the state differs from the motions by at the start fades out.
class HeldPath {
 public:
  HeldPath(const Model& model, const Eigen::VectorXd& displacement, double from, double to);
  /// Moves the held entries of `u` [3 * vertex_count] to the share s in [0, 1] of the path.
  void place(double s, Eigen::VectorXd& u) const;
  bool moves() const;
  /// Largest increment of s that turns no motion by more than what a linear prediction survives.
  double largest_increment() const;

 private:
  Eigen::VectorXd positions(double t) const;  // displacements, zero where no motion acts

  const Model& model_;
  double from_, to_;
  std::vector<Motion> motions_;
  Eigen::VectorXd offset_;
};

/// Throws Error if a part of the mesh that gravity pulls is held nowhere: it has no static equilibrium.
void require_supports(const Model& model);

}  // namespace fascia::reference
