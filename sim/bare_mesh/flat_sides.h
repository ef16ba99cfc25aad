// The flat sides of a mesh along its axes: candidates for standing on the ground, or for being held.
#pragma once
#include <array>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

/// One end of the mesh along an axis.
struct FlatSide {
  double area = 0;        // of the flat part at the end, seen along the axis
  double depth = 0;       // of that part below the very end, as a share of the extent: fills of surfaces have a rim
  double share = 0;       // of the rectangle that the whole mesh takes up, seen along the axis
  double stability = -1;  // of the mesh standing on it (foot.h)
};

struct FlatSides {
  std::array<FlatSide, 3> low, high;  // along x, y, z: facing against the axis, and along it
  Eigen::Vector3d size{0, 0, 0};
};

/// Of the boundary of `tets`, whose volumes are positive.
FlatSides flat_sides(const std::vector<Eigen::Vector3d>& positions, const std::vector<Tet>& tets);

/// The center of mass and the box of the vertices in tets.
struct Bulk {
  Eigen::AlignedBox3d box;
  Eigen::Vector3d center{0, 0, 0};
  double volume = 0;
};
Bulk bulk_of(const std::vector<Eigen::Vector3d>& positions, const std::vector<Tet>& tets);

}  // namespace fascia
