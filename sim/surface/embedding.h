// Ties points to tets so that they follow the deformation: x = X + sum_a w_a u_a with barycentric weights.
#pragma once
#include <array>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

struct EmbeddedPoint {
  Tet vertices;                   // of the tet that holds the point, or of the nearest one
  std::array<double, 4> weights;  // barycentric, sum 1; outside the mesh some are negative, none below -kLargestReach
};

/// How far outside the nearest tet a point follows it as if it went on: so much of its weights; what is farther moves
/// along with that. Unlimited weights of flat tets would throw the point about.
inline constexpr double kLargestReach = 0.5;

struct EmbeddedPoints {
  std::vector<Eigen::Vector3d> points;  // [n] rest positions [m]
  std::vector<EmbeddedPoint> ties;      // [n]
  std::size_t outside = 0;              // of all tets
  double farthest = 0;                  // of those from the nearest tet [m]
};

/// For each point the tet that contains it or else the nearest one. All tets must have positive volume.
EmbeddedPoints embed(std::vector<Eigen::Vector3d> points, const std::vector<Eigen::Vector3d>& vertices,
                     const std::vector<Tet>& tets);

}  // namespace fascia
