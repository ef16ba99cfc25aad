// The force of a tool on the tissue, at the end of a stage or as the mean over a step (sim/contact/step_loads.h).
#pragma once
#include <Eigen/Core>
#include <cstdint>

namespace fascia {

struct ToolLoad {
  Eigen::Vector3d force{0, 0, 0};   // [N] on the tissue
  Eigen::Vector3d torque{0, 0, 0};  // [N m] of that force about the origin of the tool
  double normal = 0;                // [N] sum of the normal forces of all points, whatever their directions
  std::uint32_t points = 0;         // contact points that press
  double deepest = 0;               // [m] of them inside the tool, at least 0
};

}  // namespace fascia
