// Counts what must not be: triangles of the tissue's surface that cut each other.
#pragma once
#include <vector>

#include "sim/model/model.h"

namespace fascia {

/// Whether the segment from p to q goes through the triangle a, b, c, by the signs of volumes in double precision.
bool goes_through(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& a,
                  const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// The number of pairs of surface triangles without a common vertex of which an edge of one goes through the other, at
/// displacements [vertex_count] [m].
std::size_t penetrating_triangles(const Model& model, const std::vector<Eigen::Vector3d>& displacement);

}  // namespace fascia
