// Ties points to tets so that they follow the deformation: x = X + sum_a w_a u_a with barycentric weights.
#pragma once
#include <array>
#include <vector>

#include "sim/tet_mesh.h"

namespace fascia {

struct EmbeddedPoint {
  Tet vertices;                  // of the tet that holds the point, or of the nearest one
  std::array<double, 4> weights;  // barycentric, sum 1; outside the mesh some are negative
};

/// For each point the tet whose smallest barycentric weight is largest: the one that contains it or, just outside, the
/// nearest. A grid over the tets keeps the search near the point. All tets must have positive volume.
std::vector<EmbeddedPoint> embed(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& vertices,
                                 const std::vector<Tet>& tets);

}  // namespace fascia
