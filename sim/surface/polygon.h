// Cuts polygons of surfaces into triangles, concave ones too.
#pragma once
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

/// Appends corner_count - 2 triangles, of the corners of a polygon around which `corners` leads. Ears are cut off in
/// the plane that fits the polygon best, the ear with the shortest cut first; a polygon that crosses itself is cut
/// somehow.
void triangulate(const std::vector<Eigen::Vector3d>& positions, const std::vector<std::uint32_t>& corners,
                 std::vector<Triangle>& triangles);

}  // namespace fascia
