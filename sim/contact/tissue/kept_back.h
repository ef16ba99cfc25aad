// Where a hand may lead a tool that has pressed tissue to nearly nothing. Pressed on, its tets would turn inside out,
// or the tool would pass between the places that it touches: its force falls, and what is felt is no longer tissue.
#pragma once
#include <Eigen/Core>
#include <span>

#include "sim/model/model.h"

namespace fascia {

/// The least principal stretch of a tet, below 0 where it is inside out; of quadratic ones at their four points.
/// `positions`: of the model's vertices, possibly followed by others [m].
double least_stretch(const Model& model, std::size_t tet, std::span<const Eigen::Vector3d> positions);

/// Where a tool that is led from one place to the other goes instead, so that it comes no closer to a tet that is
/// crushed, to less than 0.15 of its thickness: along these, without a turn, or nowhere. Tets farther from the tool
/// than `near` [m] were not crushed by it.
ToolPlace kept_back(const Model& model, std::span<const Eigen::Vector3d> positions, const Tool& tool,
                    const ToolPlace& from, const ToolPlace& to, double near);

}  // namespace fascia
