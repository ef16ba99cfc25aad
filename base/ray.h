// A line of sight and a section plane, shared by picking, grabbing and drawing.
#pragma once
#include <Eigen/Core>

namespace fascia {

struct Ray {
  Eigen::Vector3d origin, direction;  // [m], unit length
};

/// A plane that cuts the body open: the part with normal . x > offset is left out, and the cut is closed.
struct SectionCut {
  Eigen::Vector3f normal;  // unit length
  float offset;            // [m]
};

}  // namespace fascia
