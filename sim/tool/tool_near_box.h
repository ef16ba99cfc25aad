// Whether a tool may touch what a box contains.
#pragma once
#include <Eigen/Geometry>

#include "sim/tool/tool.h"

namespace fascia {

/// False only if every point of the box is farther than `reach` [m] from the tool. May be true up to an eighth of the
/// box's diagonal too early.
bool is_near_box(const Tool& tool, const ToolPlace& place, const Eigen::AlignedBox3d& box, double reach);

}  // namespace fascia
