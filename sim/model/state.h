// The state of a model: positions and velocities of its vertices, and what a time integrator remembers of the substep
// before.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "sim/tool/led_tools.h"

namespace fascia {

struct Model;

/// The force of one row of contact, a contact point at a piece of a tool (sim/contact/contact_surface.h).
struct ContactForce {
  Eigen::Vector3d friction{0, 0, 0};  // t [N] on the tissue, in the axes of the piece
  double normal = 0;                  // lambda [N], at least 0
  bool operator==(const ContactForce&) const = default;
};
/// A force of tissue that became softer by `factor`.
inline void soften(ContactForce& force, double factor) {
  force.friction *= factor;
  force.normal *= factor;
}
/// [rows] what contact remembers from step to step; empty: no contact so far.
using ContactMemory = std::vector<ContactForce>;

struct State {
  std::vector<Eigen::Vector3d> displacement;  // [vertex_count] u = x - X [m]
  std::vector<Eigen::Vector3d> velocity;      // [vertex_count] v [m/s]
  double time = 0;                            // [s]

  /// The same at the start of the substep before, for integrators that extrapolate (sim/integrators/stage.h). Empty:
  /// unknown, as after a reset.
  struct Earlier {
    std::vector<Eigen::Vector3d> displacement, velocity;
    double step = 0;  // length of that substep [s]; 0: unknown
  };
  Earlier earlier = {};
  /// [vertex_count] dv/dt in the last stage [m/s^2], of models with quadratic tets: supports accelerate what moves at
  /// centroids (MovingMasses in sim/model/model.h). Empty: unknown, or zero.
  std::vector<Eigen::Vector3d> acceleration = {};
  bool taken_back = false;        // the last stage (PairSearch::taken_back()), by the reference solver
  ContactMemory contact = {};     // forces that the step before left
  std::vector<LedTool> led = {};  // tools that left their paths
};
/// The rest shape of the scene, with its initial velocities, at time 0.
State initial_state(const Model& model);
/// Whether all displacements and velocities are.
bool is_finite(const State& state);

/// A vector as buffers of the GPU hold it: both solvers then start from the same numbers.
Eigen::Vector3d float32_of(const Eigen::Vector3d& v);

}  // namespace fascia
