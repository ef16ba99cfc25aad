// A rigid solid in a closed surface, as tools need it: signed distances on a grid, made once, and the surface for
// pictures. Both solvers read the same grid.
#pragma once
#include <Eigen/Core>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "sim/surface/surface_mesh.h"
#include "sim/tool/shape_distance.h"

namespace fascia {

class TriangleTree;

struct SolidMesh {
  std::vector<Eigen::Vector3d> positions;  // [m]
  std::vector<Triangle> triangles;         // wound outward
  Eigen::AlignedBox3d box;                 // around them
  double thickness = 0;                    // [m] twice the volume over the area

  Eigen::Vector3d origin{0, 0, 0};  // of the first node of the grid [m]
  double spacing = 0;               // [m]
  std::array<int, 3> count{};       // nodes along each axis
  std::vector<float> distances;     // [nodes] x first, then y, then z [m]; negative inside

  std::shared_ptr<const TriangleTree> tree;  // over the triangles
};

/// From the surface of a file, whose coordinates are multiplied by `scale`. The grid has 64 cells along the longest
/// side, and up to 128 where the solid is thin. Throws Error with `where` for a surface that is open or has no inside.
SolidMesh solid_of(const SurfaceMesh& surface, double scale, const std::string& where);

/// Distance, gradient and curvature by quadratic B-splines over the nodes: unlike those of a trilinear interpolation
/// its gradients have no jumps, at which iterations would take steps back. It rounds edges by about a cell. Outside the
/// grid a lower bound.
ShapeDistance distance_to(const SolidMesh& solid, const Eigen::Vector3d& point);
/// The distance for reports [m]: that of the grid inside of it, which presses, and beyond it that to the nearest
/// triangle.
double gap_to(const SolidMesh& solid, const Eigen::Vector3d& point);

}  // namespace fascia
