// The state of a model: where its vertices are and how fast they move.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace fascia {

struct Model;

struct State {
  std::vector<Eigen::Vector3d> displacement;  // [vertex_count] u = x - X [m]
  std::vector<Eigen::Vector3d> velocity;      // [vertex_count] v [m/s]
  double time = 0;                            // [s]
};
/// At rest as the scene says, with its initial velocities, at time 0.
State initial_state(const Model& model);

}  // namespace fascia
