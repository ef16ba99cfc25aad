// Where a hand may lead a tool that presses tissue which cannot follow: it is pressed to nearly nothing, or the
// iterations of a step have not led it out of the tool. Pressed on, its tets would turn inside out, or the tool would
// pass between the places that it touches: its force falls, and what is felt is no longer tissue.
#pragma once
#include <Eigen/Core>
#include <span>

#include "sim/contact/tissue/tissue_cover.h"
#include "sim/model/model.h"

namespace fascia {

/// The least principal stretch of a tet, below 0 where it is inside out; of quadratic ones at their four points.
/// `positions`: of the model's vertices, possibly followed by others [m].
double least_stretch(const Model& model, std::size_t tet, std::span<const Eigen::Vector3d> positions);

/// Where a tool that is led from one place to the other goes instead, so that it comes no closer to a tet that is
/// pressed to less than 0.15 of its thickness, nor goes deeper where it is in the surface by more than a quarter of
/// `near` [m]: along these, without a turn, or nowhere. Tets farther from the tool than `near` were not crushed by it.
/// `cover`: of the tissue at `positions`.
ToolPlace kept_back(const Model& model, const TissueCover& cover, std::span<const Eigen::Vector3d> positions,
                    const Tool& tool, const ToolPlace& from, const ToolPlace& to, double near);

}  // namespace fascia
