// Embeds points in tets so that they follow the deformation: x = X + sum_a w_a u_a with barycentric weights.
#pragma once
#include <array>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

struct EmbeddedPoint {
  Tet vertices;                   // of the tet that contains the point, or of the nearest one
  std::array<double, 4> weights;  // barycentric, sum 1; outside the mesh some are negative, none below -kLargestReach
};

/// The largest extrapolation of the nearest tet's motion for a point outside, in units of its weights; points farther
/// out move with the limited weights. Unlimited weights of flat tets would amplify the motion arbitrarily.
inline constexpr double kLargestReach = 0.5;

struct EmbeddedPoints {
  std::vector<Eigen::Vector3d> points;  // [n] rest positions [m]
  std::vector<EmbeddedPoint> ties;      // [n]
  std::size_t outside = 0;              // number outside all tets
  double farthest = 0;                  // largest distance of those from the nearest tet [m]
};

/// For each point the tet that contains it or else the nearest one. All tets must have positive volume.
EmbeddedPoints embed(std::vector<Eigen::Vector3d> points, const std::vector<Eigen::Vector3d>& vertices,
                     const std::vector<Tet>& tets);

}  // namespace fascia
