// A line of sight and a plane: what picking, grabbing and drawing share.
#pragma once
#include <Eigen/Core>

namespace fascia {

struct Ray {
  Eigen::Vector3d origin, direction;  // [m], unit length
};

/// A plane that cuts the body open: normal . x > offset is left out, the cut is closed.
struct SectionCut {
  Eigen::Vector3f normal;  // unit length
  float offset;            // [m]
};

}  // namespace fascia
