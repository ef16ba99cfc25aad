// Determines the side of a surface on which each point of a lattice lies.
#pragma once
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "sim/surface/bcc_lattice.h"
#include "sim/surface/triangle_tree.h"

namespace fascia {

enum Side : std::int8_t { outside = -1, on_surface = 0, inside = 1 };

/// [point_count] inside or outside. `balanced`: every edge of the surface is traversed equally often in both
/// directions, so that its winding number changes only across it.
std::vector<Side> find_sides(const TriangleTree& surface, const BccLattice& lattice, bool balanced,
                             const Progress& progress);

/// [cell_count] 1 for cells that a triangle of the surface reaches, and possibly for some of their neighbors.
std::vector<char> cells_at_surface(const TriangleTree& surface, const BccLattice& lattice);

}  // namespace fascia
