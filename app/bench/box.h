// Boxes of any number of tets for the benchmarks of speed: held at one end, bent, of one soft material.
#pragma once
#include <vector>

#include "sim/model/model.h"
#include "sim/reference/newton.h"

namespace fascia {

/// A box of 1 m x 0.25 m x 0.25 m of cells cut into 6 tets each, held at x = 0; E = 1e6 Pa, Poisson's ratio 0.3,
/// density 1000.
Model box_model(const Eigen::Vector3i& cells);

/// Cells of a box of about so many tets, as cubic as they come.
Eigen::Vector3i cells_of(std::size_t tets);

}  // namespace fascia
