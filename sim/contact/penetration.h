// Counts what must not be: triangles of the tissue's surface that cut each other.
#pragma once
#include <vector>

#include "sim/model/model.h"

namespace fascia {

/// The number of pairs of surface triangles without a common vertex of which an edge of one goes through the other, at
/// displacements [vertex_count] [m], by the signs of volumes in double precision.
std::size_t penetrating_triangles(const Model& model, const std::vector<Eigen::Vector3d>& displacement);

}  // namespace fascia
