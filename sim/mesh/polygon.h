// Divides polygons of surfaces into triangles, including concave ones.
#pragma once
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

/// Appends corner_count - 2 triangles with the corners of the polygon that `corners` traverses. Ears are cut off in the
/// best-fit plane of the polygon, the ear with the shortest cut first; the result for a self-intersecting polygon is
/// arbitrary.
void triangulate(const std::vector<Eigen::Vector3d>& positions, const std::vector<std::uint32_t>& corners,
                 std::vector<Triangle>& triangles);

}  // namespace fascia
