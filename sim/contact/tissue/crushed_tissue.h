// Tissue that a tool has pressed to nearly nothing. A hand that presses it on would turn its tets inside out, and the
// tool would then slip through: its force falls, and what is felt is no longer tissue.
#pragma once
#include <Eigen/Core>
#include <span>

#include "sim/model/model.h"

namespace fascia {

/// The least volume ratio det F of a tet, of quadratic ones at their four points. `positions`: of the model's
/// vertices, possibly followed by others [m].
double least_volume_ratio(const Model& model, std::size_t tet, std::span<const Eigen::Vector3d> positions);

/// Whether a tool that moves from one place to the other comes closer to a tet that is crushed, its volume ratio
/// below a tenth. Tets farther from the tool than `near` [m] were not crushed by it.
bool presses_crushed_tissue(const Model& model, std::span<const Eigen::Vector3d> positions, const Tool& tool,
                            const ToolPlace& from, const ToolPlace& to, double near);

}  // namespace fascia
