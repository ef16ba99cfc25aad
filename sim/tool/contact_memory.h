// What contact remembers from step to step: the force at every row, a contact point at a piece of a tool.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace fascia {

struct ContactForce {
  Eigen::Vector3d friction{0, 0, 0};  // t [N] on the tissue, in the axes of the piece
  double normal = 0;                  // lambda [N], at least 0
  bool operator==(const ContactForce&) const = default;
};
/// [rows] of a ContactSurface; empty: no contact so far.
using ContactMemory = std::vector<ContactForce>;

}  // namespace fascia
