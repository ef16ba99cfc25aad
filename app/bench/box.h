// Boxes of any number of tets for the speed benchmarks: clamped at one end, bent, of one soft material.
#pragma once
#include <vector>

#include "sim/model/model.h"
#include "sim/reference/newton.h"

namespace fascia {

/// A box of 1 m x 0.25 m x 0.25 m of cells cut into 6 tets each, clamped at x = 0; E = 1e6 Pa, Poisson's ratio 0.3,
/// density 1000.
Model box_model(const Eigen::Vector3i& cells);

/// Cells of a box with about `tets` tets, as cubic as possible.
Eigen::Vector3i cells_of(std::size_t tets);

}  // namespace fascia
