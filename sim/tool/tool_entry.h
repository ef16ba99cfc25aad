// Where the way of a contact point within a step, against the tool, enters the tool. A point that is fast enough to go
// through a tool, or so deep into it that another side is nearer, would be pressed out there, or not at all: in that
// step it meets instead the plane at which it enters. So does a point that would be there if it stayed where it is, as
// what lies on a thin plate that is lifted.
#pragma once
#include <Eigen/Core>
#include <optional>

#include "sim/tool/shape_distance.h"

namespace fascia {

/// Steps along the way, each as long as the distance allows (Hart 1996).
inline constexpr std::uint32_t kEntrySteps = 16;

struct ToolEntry {
  Eigen::Vector3d normal;  // of the plane, a unit vector
  double offset;           // signed distance of x: normal . x - offset [m]
};
/// In the axes of the shape: the point at the start of the step in those of then, where it would go and where it is if
/// it stays in those at the end. `half_thickness` of the skin. Nothing if the distance to the shape itself serves.
std::optional<ToolEntry> entry_into(const ToolShape& shape, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                    const Eigen::Vector3d& stay, double half_thickness);

}  // namespace fascia
