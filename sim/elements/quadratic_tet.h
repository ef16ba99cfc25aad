// The quadratic tetrahedron with straight edges: ten nodes, the four corners and then the middles of the edges 01, 12,
// 02, 03, 13, 23 (kMidEdgeCorners; the order of VTK and Abaqus, while Gmsh exchanges the last two).
//
//   N_a = L_a (2 L_a - 1),         grad N_a = (4 L_a - 1) g_a            corner a
//   N_ab = 4 L_a L_b,              grad N_ab = 4 (L_a g_b + L_b g_a)     middle of the edge from a to b
//   F(L) = I + sum_n u_n grad N_n(L)^T
//
// L: barycentric coordinates; g_a = grad L_a, constant because the edges are straight, so that an element at rest has
// the same ten numbers as a linear tet. F is linear in L: its values at the corners determine it everywhere.
// Integrals are means over four points, exact for polynomials of degree 2 (Hammer, Stroud 1956).
//
// With the change of volume taken pointwise, the element is too stiff where Poisson's ratio is near 0.5. Its energy
// takes it on average instead (mean dilatation: Nagtegaal, Parks, Rice 1974; Simo, Taylor, Pister 1985), which is the
// P2/P0 element with the pressure eliminated:
//
//   E = V [ mean Psi_pointwise(F_q) + K/2 (mean theta(F_q))^2 ]           (volume_split() in sim/material/law.h)
//
// Its error in displacement falls with the cube of the edges' length, and that in stress with the square, where the
// change of volume is the same everywhere; with the square and linearly where it varies.
//
// St. Venant-Kirchhoff: E = V [ mu mean eps_q : eps_q + lambda/2 (mean tr eps_q)^2 ].
//
// The kinetic energy is integrated from the velocities at the ten nodes and at the centroid, where v is that of the
// shape functions; exact for polynomials of degree 3:
//
//   1/2 m [ 1/60 sum_corners |v|^2 + 1/15 sum_middles |v|^2 + 8/15 |v_centroid|^2 ],
//   v_centroid = 1/4 sum_middles v - 1/8 sum_corners v
//
// The mass matrix so has the mass, the center and the second moments of the tet, and its row sums are the integrals of
// the shape functions, -m/20 at corners and m/5 at middles: gravity is the consistent load, under which a bar that
// hangs has its exact, quadratic displacement. Masses at the ten nodes alone cannot have both and be positive.
//
// Where every vertex needs a positive mass of its own, lumped ones stand for it, in proportion to the diagonal of the
// consistent mass matrix (Hinton, Rock, Zienkiewicz 1976).
#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "sim/elements/linear_tet.h"

namespace fascia {

struct QuadraticTet {
  static constexpr int kNodes = 10, kPoints = 4;
  using Nodes = std::array<Eigen::Vector3d, kNodes>;            // displacements [m]
  using ShapeGradients = Eigen::Matrix<double, 3, kNodes>;      // columns grad N_n [1/m]
  using PointGradients = std::array<Eigen::Matrix3d, kPoints>;  // one matrix per point or per corner

  using Barycentric = Eigen::Vector4d;
  using ShapeFunctions = std::array<double, kNodes>;
  /// N_n(L), and N_n(L) + dN_n/dL d, which continues the motion at L without its curvature.
  static ShapeFunctions shape_functions(const Barycentric& barycentric);
  static ShapeFunctions shape_functions(const Barycentric& barycentric, const Barycentric& displaced);

  /// Barycentric coordinates of point q: kNear for corner q, kFar for the three others. Every weight is V / 4.
  static constexpr double kNear = 0.58541019662496845446, kFar = 0.13819660112501051518;  // (5 + 3 sqrt 5) / 20, ...
  static const std::vector<Barycentric>& points();
  /// Shares of the mass of the element: lumped; what moves with a node itself and with the centroid; row sums.
  static constexpr double kCornerMass = 1.0 / 36, kMidEdgeMass = 4.0 / 27;
  static constexpr double kOwnCornerMass = 1.0 / 60, kOwnMidEdgeMass = 1.0 / 15, kCentroidMass = 8.0 / 15;
  static constexpr double kCornerLoad = -1.0 / 20, kMidEdgeLoad = 1.0 / 5;
  /// N_n at the centroid.
  static constexpr double at_centroid(std::size_t node) { return node < 4 ? -1.0 / 8 : 1.0 / 4; }

  /// From the linear tet of its corners.
  explicit QuadraticTet(const LinearTet& corners) : gradients(corners.gradients), volume(corners.volume) {}

  Eigen::Matrix<double, 3, 4> gradients;  // g_a, columns [1/m]
  double volume;                          // V [m^3]

  ShapeGradients shape_gradients(const Eigen::Vector4d& barycentric) const;
  ShapeGradients shape_gradients_at_point(int q) const;
  /// F - I, from differences of displacements, so that neither the identity nor a common translation costs accuracy.
  PointGradients at_corners(const Nodes& displacements) const;
  PointGradients at_points(const Nodes& displacements) const;
  Eigen::Matrix3d at_centroid(const Nodes& displacements) const;  // the mean over the element
};

}  // namespace fascia
