// The two-level method in double precision, from its equations (docs/concepts/solver.md): the reference for the tests
// of the GPU's passes.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "sim/coarse/coarse_gather.h"
#include "sim/coarse/coarse_space.h"
#include "sim/reference/elastic_system.h"
#include "sim/scene/settings/solver_settings.h"

namespace fascia::test {

class DoubleTwoLevel {
 public:
  /// `start`: initial u of the iterations, `predicted`: u~; both [3 * vertex_count].
  DoubleTwoLevel(const Model& model, double h, const Eigen::VectorXd& start, const Eigen::VectorXd& predicted);

  const Eigen::VectorXd& displacement() const { return u_; }
  /// g = M (u - u~) + h^2 dU/du, 0 where constrained, and the objective [kg m^2].
  Eigen::VectorXd gradient(const Eigen::VectorXd& u, double& objective) const;
  Eigen::VectorXd fine(const Eigen::VectorXd& gradient) const;    // of the blocks at the start
  Eigen::VectorXd coarse(const Eigen::VectorXd& gradient) const;  // with the current rotations
  void begin(const Eigen::VectorXd& base);  // the start is a step from `base`, which descend() evaluates
  /// The step within the span of z_f, z_c and the last step (subspace), of z_f + z_c and the last step (nonlinear_cg),
  /// or of z_f + z_c (none); the first one's without the last step. Only a part of a step that raised the objective is
  /// kept.
  void descend(Acceleration acceleration);

 private:
  const Model& model_;
  double h_;
  reference::ElasticSystem system_;
  Eigen::VectorXd u_, predicted_, mass_, last_step_, previous_gradient_;
  double objective_ = 0;  // before the last step
  bool inertia_ = false;  // whether the last step is that of begin()
  std::vector<Eigen::Matrix3d> block_inverse_;
  CoarseSpace space_;
  CoarseGather gather_;
  Eigen::MatrixXd coarse_inverse_;
};

}  // namespace fascia::test
