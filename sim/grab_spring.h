// A spring that pulls a vertex to a target, as the mouse does.
#pragma once
#include <Eigen/Core>
#include <cstdint>

namespace fascia {

struct GrabSpring {
  std::uint32_t vertex;
  Eigen::Vector3d target;  // displacement the spring pulls to [m]
  double stiffness;        // [N/m]
  bool operator==(const GrabSpring&) const = default;
};

}  // namespace fascia
