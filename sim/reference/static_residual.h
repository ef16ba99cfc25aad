// The distance of a state from static equilibrium, in double precision for any solver's result.
#pragma once
#include "sim/reference/elastic_system.h"
#include "sim/reference/newton.h"

namespace fascia::reference {

class StaticResidual {
 public:
  /// `model` must outlive this object, and its gravity and materials must not change.
  explicit StaticResidual(const Model& model);
  /// Norm over the free vertices of the elastic energy's gradient minus the weight, the springs' forces and those of
  /// contact ([vertex] [N], or empty), relative to the larger norm of the weight with the springs and of the gradient
  /// at all vertices, which at constrained ones is the reaction. 0 without any forces.
  double operator()(const State& state, const std::vector<GrabSpring>& springs = {},
                    const std::vector<Eigen::Vector3d>& contact = {}) const;

 private:
  ElasticSystem system_;
  Eigen::VectorXd weight_;  // [3 * vertex_count] [N]
};

}  // namespace fascia::reference
