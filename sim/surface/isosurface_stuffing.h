// Tets that fill a closed surface: isosurface stuffing (Labelle, Shewchuk 2007) on a body-centered cubic lattice.
//
// Lattice points near the surface are moved onto it, and tets that it still cuts are divided by a fixed table. So every
// dihedral angle stays within bounds that do not depend on the surface (kSmallestDihedral), and the boundary follows
// the surface, where a grid of cubes would be a staircase. Unlike in the paper, tets that the surface passes through
// are kept whole where it is too thin for the lattice to resolve its inside.
#pragma once
#include "base/progress.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/surface/triangle_tree.h"

namespace fascia {

struct LatticeFill {
  std::vector<Eigen::Vector3d> positions;  // [m]
  std::vector<Tet> tets;                   // positive volume
  double spacing = 0;                      // of the lattice [m]
  std::size_t whole = 0;                   // tets kept whole because the surface is too thin there
  std::size_t apart = 0;                   // of those: touch no tet with a vertex inside, as along a vessel
};

/// Bounds of every filling in degrees. The fillings of the tests are between 10.7 and 158.
inline constexpr double kSmallestDihedral = 8, kLargestDihedral = 166;

/// `surface` is wound outward. `balanced`: each of its edges is traversed equally often in both directions, as in every
/// closed surface without walls inside (then points that it does not separate are on the same side). `cells` is their
/// number along the longest side of its box.
LatticeFill fill_inside(const TriangleTree& surface, bool balanced, int cells, const Progress& progress = {});

}  // namespace fascia
