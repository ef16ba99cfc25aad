// Cells of a mesh file as tets and faces.
#pragma once
#include <cstdint>
#include <span>

#include "sim/mesh/mesh_file.h"

namespace fascia {

/// Adds a tet, or a pyramid, wedge or hexahedron (4, 5, 6 or 8 corners, in the order of VTK and Gmsh) as tets. The
/// diagonal of each face begins at its vertex with the smallest index, so that neighbors agree (Dompierre, Labbe,
/// Vallet, Camarero 1999). Returns the number of tets, which is 0 for a cell whose corners collapse. Regions are left
/// to the caller.
std::size_t add_solid(MeshFile& file, std::span<const std::uint32_t> corners);

/// Gives the last tet of the file its mid-edge vertices, in the order of kMidEdgeCorners.
void set_mid_edges(MeshFile& file, const MidEdges& mid_edges);

/// Adds a polygon; one with fewer than three corners is counted as a point or a line.
void add_face(MeshFile& file, std::span<const std::uint32_t> corners);

}  // namespace fascia
