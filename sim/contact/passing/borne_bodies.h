// Free bodies that tools bear or hold on the way of a static solve. It goes to equilibria from rest, so that a body
// that does not begin where its tools have gone would be left behind.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sim/contact/contact_surface.h"
#include "sim/tool/tool_motion.h"

namespace fascia {

class BorneBodies {
 public:
  /// Both references must outlive this object.
  BorneBodies(const Model& model, const ContactSurface& contact);
  /// Takes along what moving tools alone press by the forces in `memory`, if all of them move alike and press nothing
  /// else: its displacements in `u` [3 * vertex_count] become those at the end of `motion`, in which these tools then
  /// stand still.
  void carry(const ContactMemory& memory, Eigen::VectorXd& u, ToolMotion& motion) const;

 private:
  struct Press {
    std::uint32_t piece, point, part;  // in ContactSurface::pieces and points; UnconstrainedParts::part
  };
  std::vector<Press> presses(const ContactMemory& memory) const;

  const Model& model_;
  const ContactSurface& contact_;
  std::vector<std::uint32_t> part_of_;  // [vertex_count] UnconstrainedParts::part
};

}  // namespace fascia
