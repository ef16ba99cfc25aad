// Embeds points in tets so that they follow the deformation: x = X + sum_a w_a u_a with barycentric weights, in
// quadratic tets with those of all ten shape functions.
#pragma once
#include <array>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

struct EmbeddedPoint {
  Tet vertices;                   // of the tet that contains the point, or of the nearest one
  std::array<double, 4> weights;  // barycentric, sum 1; outside the mesh some are negative, none below -kLargestReach
};

/// The same in a quadratic tet. Outside of it the motion at the nearest point is continued without its curvature.
struct QuadraticTie {
  MidEdges middles = kNoMidEdges;
  std::array<double, 10> weights{};  // of the corners, then of `middles`; sum 1. In a linear tet those of its corners
};

/// The largest extrapolation of the nearest tet's motion for a point outside, in units of its weights; points farther
/// out move with the limited weights. Unlimited weights of flat tets would amplify the motion arbitrarily.
inline constexpr double kLargestReach = 0.5;

struct EmbeddedPoints {
  std::vector<Eigen::Vector3d> points;  // [n] rest positions [m]
  std::vector<EmbeddedPoint> ties;      // [n]
  std::vector<QuadraticTie> quadratic;  // [n]; empty if all tets are linear
  std::size_t outside = 0;              // number outside all tets
  double farthest = 0;                  // largest distance of those from the nearest tet [m]
};

/// For each point the tet that contains it or else the nearest one. All tets must have positive volume. `mid_edges`:
/// [tets], or empty if all are linear.
EmbeddedPoints embed(std::vector<Eigen::Vector3d> points, const std::vector<Eigen::Vector3d>& vertices,
                     const std::vector<Tet>& tets, const std::vector<MidEdges>& mid_edges = {});
/// [n] what a field over the vertices has at the points: of displacements their motion.
std::vector<Eigen::Vector3d> at_points(const EmbeddedPoints& points, const std::vector<Eigen::Vector3d>& of_vertices);
/// Adds the points of another body.
void append(EmbeddedPoints& points, const EmbeddedPoints& more);

}  // namespace fascia
