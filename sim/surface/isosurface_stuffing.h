// Tets that fill a closed surface: isosurface stuffing (Labelle, Shewchuk 2007) on a body-centered cubic lattice.
//
// Lattice points near the surface are moved onto it, tets that it still cuts are cut by a fixed table, so that every
// dihedral angle stays between bounds that do not depend on the surface (kSmallestDihedral) and the boundary follows
// the surface, where a box of cubes would be a staircase. Changed: where the surface is too thin for the lattice to see
// its inside, the tets that it passes through are kept whole.
#pragma once
#include "base/progress.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/surface/triangle_tree.h"

namespace fascia {

struct LatticeFill {
  std::vector<Eigen::Vector3d> positions;  // [m]
  std::vector<Tet> tets;                   // positive volume
  double spacing = 0;                      // of the lattice [m]
  std::size_t whole = 0;                   // tets kept because the surface is too thin there
};

/// Degrees; what every filling keeps. Those of the tests are between 10.7 and 158.
inline constexpr double kSmallestDihedral = 8, kLargestDihedral = 166;

/// `surface` is wound outward; `balanced`: each of its edges is passed as often one way as the other, as in every
/// closed surface without walls inside (then points between which it does not pass are on the same side); `cells` lie
/// along the longest side of its box.
LatticeFill fill_inside(const TriangleTree& surface, bool balanced, int cells, const Progress& progress = {});

}  // namespace fascia
