// How far a simulated shape is from a measured one.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "sim/fit/measured/measurement.h"

namespace fascia {

/// [value_count] of the shape [m]: simulated minus measured components of vertices, or for points of a surface their
/// distance to the boundary of the simulated tets, positive outside.
std::vector<double> distances_to(const MeasuredShape& shape, const Model& model,
                                 const std::vector<Eigen::Vector3d>& displacement);

}  // namespace fascia
