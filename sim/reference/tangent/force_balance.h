// The forces of a scene whose materials, loads and prescribed places are near those of a model: what implicit
// differentiation compares at one displacement (static_tangent.h, step_tangent.h).
#pragma once
#include <Eigen/Core>
#include <vector>

#include "sim/model/grab_spring.h"
#include "sim/model/model.h"
#include "sim/reference/elastic_system.h"
#include "sim/reference/mass_matrix.h"

namespace fascia::reference {

/// The scene at another value of a parameter, of the same mesh and the same constrained vertices.
struct Nearby {
  const Model& model;
  const std::vector<GrabSpring>& springs;
};

class ForceBalance {
 public:
  explicit ForceBalance(const Model& model);
  ForceBalance(const ForceBalance&) = delete;
  ForceBalance& operator=(const ForceBalance&) = delete;

  /// Whose materials are those of the last scene that was evaluated or set.
  const ElasticSystem& system() const { return system_; }
  void set_materials(const Model& nearby) { model_.materials = nearby.materials; }
  /// `u` [3 * vertex_count] with the prescribed vertices where the motions of `nearby` have them at `time` [s].
  Eigen::VectorXd placed(const Eigen::VectorXd& u, const Model& nearby, double time) const;
  /// Elastic, viscous and spring forces at all vertices [3 * vertex_count] [N], as gradients of their energies.
  Eigen::VectorXd inner_forces(const Nearby& nearby, const Eigen::VectorXd& u, const ViscousStep& viscous);
  MassMatrix masses(const Model& nearby);
  /// Lumped masses times gravity [3 * vertex_count] [N].
  Eigen::VectorXd weight(const Model& nearby);
  Eigen::VectorXd gravity(const Model& nearby) const;  // at every vertex [3 * vertex_count] [m/s^2]
  /// Stiffness of springs at each component [3 * vertex_count] [N/m].
  Eigen::VectorXd stiffness(const std::vector<GrabSpring>& springs) const;

 private:
  Model model_;
  const ElasticSystem system_;
};

}  // namespace fascia::reference
